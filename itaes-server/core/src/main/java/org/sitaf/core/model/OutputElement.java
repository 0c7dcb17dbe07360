package org.sitaf.core.model;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * A test element of {@code output_spec_list}: something that the test looks at.
 *
 * @param realType the type as the model spells it
 * @param type the type that the spelling means
 * @param expected CEL expression over the inputs and {@code valid}; null where nothing is expected
 * @param line where it stands in the model, from 1; 0 where that is unknown
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

  /** The same element with the type that an interface gives it. */
  public OutputElement withType(DataType resolved) {
    return new OutputElement(
        name, kind, realType, resolved, description, expected, tolerance, line);
  }
}
