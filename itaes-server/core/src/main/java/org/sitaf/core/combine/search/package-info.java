/** Searches rows: greedy growth, then a local search that removes rows one by one. */
@NullMarked
package org.sitaf.core.combine.search;

import org.jspecify.annotations.NullMarked;
