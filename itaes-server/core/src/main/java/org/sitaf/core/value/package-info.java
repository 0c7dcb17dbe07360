/** Test Data Generator (TDG): the values of one test element. */
@NullMarked
package org.sitaf.core.value;

import org.jspecify.annotations.NullMarked;
