/** The client of the robot simulator; no type of its wire leaves this package. */
@NullMarked
package org.sitaf.runtime.simulation;

import org.jspecify.annotations.NullMarked;
