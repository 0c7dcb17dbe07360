/** Reading test cases and writing records of results. */
@NullMarked
package org.sitaf.runtime.suite;

import org.jspecify.annotations.NullMarked;
