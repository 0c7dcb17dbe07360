package org.sitaf.core.score.fault;

import java.util.Objects;
import java.util.function.UnaryOperator;

/**
 * A fault of a single value.
 *
 * @param text names the fault, such as {@code radians taken for degrees}
 * @param change of the literal; gives the same literal where the fault has no effect
 */
record ValueChange(String text, UnaryOperator<String> change) {
  ValueChange {
    Objects.requireNonNull(text);
    Objects.requireNonNull(change);
  }

  /** The changed literal. */
  String apply(String literal) {
    return change.apply(literal);
  }
}
