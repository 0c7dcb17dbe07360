/** When schedules fire. */
@NullMarked
package org.sitaf.server.schedule.timing;

import org.jspecify.annotations.NullMarked;
