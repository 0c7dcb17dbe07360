/** The state of the simulated world at one step, and its preparation in bulk. */
@NullMarked
package org.sitaf.runtime.simulation.frozen;

import org.jspecify.annotations.NullMarked;
