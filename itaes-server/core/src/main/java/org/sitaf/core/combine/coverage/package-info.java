/**
 * Which tuples a set of rows covers, and how often: bit sets and counts that change with a cell.
 */
@NullMarked
package org.sitaf.core.combine.coverage;

import org.jspecify.annotations.NullMarked;
