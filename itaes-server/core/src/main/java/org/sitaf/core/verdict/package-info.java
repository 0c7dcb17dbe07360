/** Evaluates recorded cases: expected values, post-conditions, verdicts, statistics. */
@NullMarked
package org.sitaf.core.verdict;

import org.jspecify.annotations.NullMarked;
