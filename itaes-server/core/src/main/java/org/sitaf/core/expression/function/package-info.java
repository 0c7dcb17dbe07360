/** The functions of expressions: arithmetic, angles, vectors, matrices and quaternions. */
@NullMarked
package org.sitaf.core.expression.function;

import org.jspecify.annotations.NullMarked;
