/** What the simulated world shows at one step, as the simulator told it or prepared it ahead. */
@NullMarked
package org.sitaf.runtime.simulation.frozen;

import org.jspecify.annotations.NullMarked;
