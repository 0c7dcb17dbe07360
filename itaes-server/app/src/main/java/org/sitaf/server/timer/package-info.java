/** Periodic tasks of the server. */
@NullMarked
package org.sitaf.server.timer;

import org.jspecify.annotations.NullMarked;
