package org.sitaf.core.score;

import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;

/**
 * Restricts a fault to some cases.
 *
 * @param text such as {@code where Speed is 7}
 * @param holds over the values of a case
 */
record Condition(String text, Predicate<List<String>> holds) {
  Condition {
    Objects.requireNonNull(text);
    Objects.requireNonNull(holds);
  }
}
