/** Finished cases of running builds, for the live view. */
@NullMarked
package org.sitaf.server.result.live;

import org.jspecify.annotations.NullMarked;
