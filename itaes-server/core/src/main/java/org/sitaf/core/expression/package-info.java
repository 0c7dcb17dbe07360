/** Conditions and expected values in CEL, over the inputs and outputs of a case by name. */
@NullMarked
package org.sitaf.core.expression;

import org.jspecify.annotations.NullMarked;
