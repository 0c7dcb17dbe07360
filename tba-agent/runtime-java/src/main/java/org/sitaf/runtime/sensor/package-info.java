/** Sensors, with the data of {@code sensor_msgs} in SI units. */
@NullMarked
package org.sitaf.runtime.sensor;

import org.jspecify.annotations.NullMarked;
