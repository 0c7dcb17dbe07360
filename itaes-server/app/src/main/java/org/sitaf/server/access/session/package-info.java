/** Signing in and out. */
@NullMarked
package org.sitaf.server.access.session;

import org.jspecify.annotations.NullMarked;
