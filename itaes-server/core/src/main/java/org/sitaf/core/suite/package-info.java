/** Test cases: values combined, expected values from the oracle, and their document. */
@NullMarked
package org.sitaf.core.suite;

import org.jspecify.annotations.NullMarked;
