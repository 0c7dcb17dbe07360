/** The state of the simulated world at one step, read from the simulator or prepared ahead. */
@NullMarked
package org.sitaf.runtime.simulation.frozen;

import org.jspecify.annotations.NullMarked;
