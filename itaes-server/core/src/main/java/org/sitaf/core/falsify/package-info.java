/**
 * Falsification: searches the ranges of a model's numeric inputs for the case with the smallest
 * margin of a trajectory condition.
 */
@org.jspecify.annotations.NullMarked
package org.sitaf.core.falsify;
