package org.sitaf.core.model;

import java.util.Objects;

/**
 * A pre- or post-condition in CEL.
 *
 * @param line line in the model, from 1; 0 if unknown
 */
public record Condition(String expression, int line) {
  public Condition {
    Objects.requireNonNull(expression);
  }
}
