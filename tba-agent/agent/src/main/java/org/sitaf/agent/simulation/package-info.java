/**
 * The robot simulator as an agent uses it: a bridge of its own, one that runs elsewhere, or none.
 */
@NullMarked
package org.sitaf.agent.simulation;

import org.jspecify.annotations.NullMarked;
