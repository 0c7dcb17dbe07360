/** Counts the tuples that a set of rows covers, with fast updates when a cell changes. */
@NullMarked
package org.sitaf.core.combine.coverage;

import org.jspecify.annotations.NullMarked;
