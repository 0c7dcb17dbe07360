package org.sitaf.core.suite;

import java.util.Objects;

/**
 * The expected value of an output.
 *
 * @param output name of the output; empty if the model has only one
 * @param literal as in {@link org.sitaf.core.model.Value#literal()}
 */
public record ExpectedValue(String output, String literal) {
  /** Prefix of an expected value that could not be computed. Such a case is reported as ERROR. */
  public static final String UNEVALUATED = "!unevaluated:";

  public ExpectedValue {
    Objects.requireNonNull(output);
    Objects.requireNonNull(literal);
  }
}
