/** Tests of timers. */
@NullMarked
package org.sitaf.server.timer;

import org.jspecify.annotations.NullMarked;
