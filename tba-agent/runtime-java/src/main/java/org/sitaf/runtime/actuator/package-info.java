/** Actuators. A command holds until the next one and takes effect when simulation time advances. */
@NullMarked
package org.sitaf.runtime.actuator;

import org.jspecify.annotations.NullMarked;
