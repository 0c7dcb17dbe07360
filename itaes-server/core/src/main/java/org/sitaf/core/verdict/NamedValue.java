package org.sitaf.core.verdict;

import java.util.Objects;

/**
 * The value of an output.
 *
 * @param output name of the output; empty if the model has only one
 */
public record NamedValue(String output, String literal) {
  public NamedValue {
    Objects.requireNonNull(output);
    Objects.requireNonNull(literal);
  }
}
