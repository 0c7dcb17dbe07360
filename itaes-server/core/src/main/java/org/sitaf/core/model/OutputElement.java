package org.sitaf.core.model;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * A test element of {@code output_spec_list}: an output that the test checks.
 *
 * @param realType type as written in the model
 * @param type resolved type
 * @param expected CEL expression over the inputs and {@code valid}; null if nothing is expected
 * @param line line in the model, from 1; 0 if unknown
 */
public record OutputElement(
    String name,
    OutputKind kind,
    String realType,
    DataType type,
    String description,
    @Nullable String expected,
    Tolerance tolerance,
    int line) {
  /** The name of the return value. */
  public static final String RETURN_NAME = "return";

  public OutputElement {
    Objects.requireNonNull(name);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(realType);
    Objects.requireNonNull(type);
    Objects.requireNonNull(description);
    Objects.requireNonNull(tolerance);
  }

  /** A copy with another resolved type. */
  public OutputElement withType(DataType resolved) {
    return new OutputElement(
        name, kind, realType, resolved, description, expected, tolerance, line);
  }
}
