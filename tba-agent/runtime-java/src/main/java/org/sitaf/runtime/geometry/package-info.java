/** Vectors and rotations. */
@NullMarked
package org.sitaf.runtime.geometry;

import org.jspecify.annotations.NullMarked;
