package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * A test element of {@code output_spec_list}: an output that the test checks.
 *
 * @param realType type as written in the model
 * @param type resolved type
 * @param expected CEL expression over the inputs and {@code valid}; null if nothing is expected
 * @param orErrors names of exceptions that pass as well as the expected value
 * @param line line in the model, from 1; 0 if unknown
 * @param expectedLine line of the expected value
 */
public record OutputElement(
    String name,
    OutputKind kind,
    String realType,
    DataType type,
    String description,
    @Nullable String expected,
    List<String> orErrors,
    Tolerance tolerance,
    int line,
    int expectedLine) {
  /** The name of the return value. */
  public static final String RETURN_NAME = "return";

  public OutputElement {
    Objects.requireNonNull(name);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(realType);
    Objects.requireNonNull(type);
    Objects.requireNonNull(description);
    orErrors = List.copyOf(orErrors);
    Objects.requireNonNull(tolerance);
  }

  /** An output whose expected value no exception replaces. */
  public OutputElement(
      String name,
      OutputKind kind,
      String realType,
      DataType type,
      String description,
      @Nullable String expected,
      Tolerance tolerance,
      int line) {
    this(name, kind, realType, type, description, expected, List.of(), tolerance, line, line);
  }

  /** A copy without an expected value. */
  public OutputElement withoutExpected() {
    return new OutputElement(
        name, kind, realType, type, description, null, List.of(), tolerance, line, expectedLine);
  }

  /** A copy with another resolved type. */
  public OutputElement withType(DataType resolved) {
    return new OutputElement(
        name,
        kind,
        realType,
        resolved,
        description,
        expected,
        orErrors,
        tolerance,
        line,
        expectedLine);
  }
}
