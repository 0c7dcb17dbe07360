/** What all of the HTTP interface shares. */
@NullMarked
package org.sitaf.server.web;

import org.jspecify.annotations.NullMarked;
