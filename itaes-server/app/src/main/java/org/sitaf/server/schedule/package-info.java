/** Schedules: builds at reserved times and periodically; Quartz keeps the time. */
@NullMarked
package org.sitaf.server.schedule;

import org.jspecify.annotations.NullMarked;
