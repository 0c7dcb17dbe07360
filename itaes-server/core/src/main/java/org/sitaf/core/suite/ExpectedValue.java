package org.sitaf.core.suite;

import java.util.Objects;

/**
 * What an output should be.
 *
 * @param output name of the output; empty where the model has only one
 * @param literal as in {@link org.sitaf.core.model.Value#literal()}
 */
public record ExpectedValue(String output, String literal) {
  public ExpectedValue {
    Objects.requireNonNull(output);
    Objects.requireNonNull(literal);
  }
}
