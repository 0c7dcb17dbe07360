/** Test cases: values combined, and expected values from the oracle. */
@NullMarked
package org.sitaf.core.suite;

import org.jspecify.annotations.NullMarked;
