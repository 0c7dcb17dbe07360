/** Test Data Generator (TDG): generates the values of a test element. */
@NullMarked
package org.sitaf.core.value;

import org.jspecify.annotations.NullMarked;
