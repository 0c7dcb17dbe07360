package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * A test element of {@code input_spec_list}: an input that the test varies.
 *
 * @param realType type as written in the model
 * @param type resolved type
 * @param spec how values are generated; null if only user values are used
 * @param userValues values that the user lists
 * @param line line in the model, from 1; 0 if unknown
 */
public record InputElement(
    String name,
    InputKind kind,
    String realType,
    DataType type,
    String description,
    @Nullable TestSpec spec,
    List<Value> userValues,
    int line) {
  public InputElement {
    Objects.requireNonNull(name);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(realType);
    Objects.requireNonNull(type);
    Objects.requireNonNull(description);
    userValues = List.copyOf(userValues);
  }

  /** A copy with another resolved type. */
  public InputElement withType(DataType resolved) {
    return new InputElement(name, kind, realType, resolved, description, spec, userValues, line);
  }
}
