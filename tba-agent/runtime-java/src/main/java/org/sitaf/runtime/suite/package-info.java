/** Test cases in, result lines out, and the comparison between them. */
@NullMarked
package org.sitaf.runtime.suite;

import org.jspecify.annotations.NullMarked;
