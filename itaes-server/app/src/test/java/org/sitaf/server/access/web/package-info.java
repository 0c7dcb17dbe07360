/** Tests of the checks at startup. */
@NullMarked
package org.sitaf.server.access.web;

import org.jspecify.annotations.NullMarked;
