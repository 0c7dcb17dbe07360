/** When schedules fire: times, days to leave out, and what becomes of times that were missed. */
@NullMarked
package org.sitaf.server.schedule.timing;

import org.jspecify.annotations.NullMarked;
