/**
 * Algebraic constructions of covering arrays. For suitable levels, they are smaller than arrays
 * found by search.
 */
@NullMarked
package org.sitaf.core.combine.construction;

import org.jspecify.annotations.NullMarked;
