/** The client of the robot simulator; no type of its wire leaves this package and those below. */
@NullMarked
package org.sitaf.runtime.simulation;

import org.jspecify.annotations.NullMarked;
