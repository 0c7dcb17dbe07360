/** What a component drives; commands hold until the next one, and act when time moves. */
@NullMarked
package org.sitaf.runtime.actuator;

import org.jspecify.annotations.NullMarked;
