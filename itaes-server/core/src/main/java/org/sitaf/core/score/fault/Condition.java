package org.sitaf.core.score.fault;

import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;

/**
 * Restricts a fault to some cases.
 *
 * @param text such as {@code where Speed is 7}
 * @param single whether it is about one input, or the order of two
 * @param holds over the values of a case
 */
public record Condition(String text, boolean single, Predicate<List<String>> holds) {
  public Condition {
    Objects.requireNonNull(text);
    Objects.requireNonNull(holds);
  }
}
