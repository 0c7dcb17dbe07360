/** Schedules: builds at fixed times and periodically, based on Quartz. */
@NullMarked
package org.sitaf.server.schedule;

import org.jspecify.annotations.NullMarked;
