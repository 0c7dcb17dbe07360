/** Explains failures: the smallest sets of values that fail, and the simplest case of each. */
@org.jspecify.annotations.NullMarked
package org.sitaf.core.explain;
