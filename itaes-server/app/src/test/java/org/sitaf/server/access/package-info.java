/** Tests of authentication and authorization. */
@NullMarked
package org.sitaf.server.access;

import org.jspecify.annotations.NullMarked;
