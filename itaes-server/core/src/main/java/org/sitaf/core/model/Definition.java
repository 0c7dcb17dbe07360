package org.sitaf.core.model;

import java.util.Objects;

/**
 * A named sub-expression in CEL.
 *
 * @param line line in the model, from 1; 0 if unknown
 */
public record Definition(String name, String expression, int line) {
  public Definition {
    Objects.requireNonNull(name);
    Objects.requireNonNull(expression);
  }
}
