/**
 * Compiles and evaluates CEL: conditions and expected values over the inputs and outputs of a case.
 */
@NullMarked
package org.sitaf.core.expression;

import org.jspecify.annotations.NullMarked;
