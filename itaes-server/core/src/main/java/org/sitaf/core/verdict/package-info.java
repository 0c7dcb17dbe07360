/** Results of cases: their verdicts by post-conditions, calls and statistics. */
@NullMarked
package org.sitaf.core.verdict;

import org.jspecify.annotations.NullMarked;
