package org.sitaf.core.compare;

import java.util.Objects;

/**
 * Something that only one version has, or that could not be executed.
 *
 * @param no number of the case; 0 for all cases of the model
 * @param output name of the output; empty for the whole case or model
 */
public record NotComparable(String model, int no, String output, String reason) {
  public NotComparable {
    Objects.requireNonNull(model);
    Objects.requireNonNull(output);
    Objects.requireNonNull(reason);
  }
}
