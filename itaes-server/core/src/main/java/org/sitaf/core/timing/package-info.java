/** Repeated calls of a case: their number, the statistics of their times, and comparisons. */
@NullMarked
package org.sitaf.core.timing;

import org.jspecify.annotations.NullMarked;
