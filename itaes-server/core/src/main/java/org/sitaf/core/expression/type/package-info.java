/** The static types of expressions: found before anything is evaluated. */
@NullMarked
package org.sitaf.core.expression.type;

import org.jspecify.annotations.NullMarked;
