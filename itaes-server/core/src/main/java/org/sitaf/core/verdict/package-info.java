/** Results of cases: post-conditions, statistics, and the test result descriptor. */
@NullMarked
package org.sitaf.core.verdict;

import org.jspecify.annotations.NullMarked;
