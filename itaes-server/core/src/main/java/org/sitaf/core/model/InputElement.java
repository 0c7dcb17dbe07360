package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.description.DataType;

/**
 * A test element of {@code input_spec_list}: an input that the test varies.
 *
 * @param realType type as written in the model
 * @param type resolved type
 * @param specs how values are generated; the values are the union of all
 * @param userValues values that the user lists
 * @param line line in the model, from 1; 0 if unknown
 */
public record InputElement(
    String name,
    InputKind kind,
    String realType,
    DataType type,
    String description,
    List<TestSpec> specs,
    List<Value> userValues,
    int line) {
  public InputElement {
    Objects.requireNonNull(name);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(realType);
    Objects.requireNonNull(type);
    Objects.requireNonNull(description);
    specs = List.copyOf(specs);
    userValues = List.copyOf(userValues);
  }

  /**
   * Parses a value of a case; an answer of a stub may also be an error or a delay.
   *
   * @throws IllegalArgumentException if it is not a value of the type
   */
  public Value value(String literal) {
    return kind == InputKind.TDTS ? Value.parseAnswer(literal, type) : Value.parse(literal, type);
  }

  /** A copy with another resolved type. */
  public InputElement withType(DataType resolved) {
    return new InputElement(name, kind, realType, resolved, description, specs, userValues, line);
  }
}
