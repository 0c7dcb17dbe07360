package org.sitaf.core.model;

import java.util.Objects;

/**
 * A pre- or post-condition in CEL.
 *
 * @param name appears in messages; empty if the expression itself does
 * @param line line in the model, from 1; 0 if unknown
 */
public record Condition(String name, String expression, int line) {
  public Condition {
    Objects.requireNonNull(name);
    Objects.requireNonNull(expression);
  }

  /** A condition without a name. */
  public Condition(String expression, int line) {
    this("", expression, line);
  }
}
