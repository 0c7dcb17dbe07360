/** What a component reads, in shapes of {@code sensor_msgs} and SI units. */
@NullMarked
package org.sitaf.runtime.sensor;

import org.jspecify.annotations.NullMarked;
