/** The fire times of schedules: times, excluded days and misfire policies. */
@NullMarked
package org.sitaf.server.schedule.timing;

import org.jspecify.annotations.NullMarked;
