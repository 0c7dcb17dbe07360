/** Decides which rows and tuples the constraints allow. */
@NullMarked
package org.sitaf.core.combine.feasible;

import org.jspecify.annotations.NullMarked;
