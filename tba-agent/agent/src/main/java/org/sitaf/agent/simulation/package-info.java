/** Robot simulators of an agent: bridges that it starts, an existing simulator, or none. */
@NullMarked
package org.sitaf.agent.simulation;

import org.jspecify.annotations.NullMarked;
