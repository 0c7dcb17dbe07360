/** Cases whose verdicts or values differ between equal runs, and what makes them differ. */
@NullMarked
package org.sitaf.core.flaky;

import org.jspecify.annotations.NullMarked;
