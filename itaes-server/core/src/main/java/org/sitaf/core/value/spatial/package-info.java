/** Rotations, directions and poses as whole values of test elements. */
@NullMarked
package org.sitaf.core.value.spatial;

import org.jspecify.annotations.NullMarked;
