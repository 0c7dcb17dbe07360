/** Reserved builds, by Quartz. */
@NullMarked
package org.sitaf.server.schedule;

import org.jspecify.annotations.NullMarked;
