/** Tests of the common parts of the HTTP interface. */
@NullMarked
package org.sitaf.server.web;

import org.jspecify.annotations.NullMarked;
