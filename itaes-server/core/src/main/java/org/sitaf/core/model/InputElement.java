package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * A test element of {@code input_spec_list}: something that the test varies.
 *
 * @param realType the type as the model spells it
 * @param type the type that the spelling means
 * @param spec how values are generated; null where only the user's values are tried
 * @param userValues specific candidate values
 * @param line where it stands in the model, from 1; 0 where that is unknown
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

  /** The same element with the type that an interface gives it. */
  public InputElement withType(DataType resolved) {
    return new InputElement(name, kind, realType, resolved, description, spec, userValues, line);
  }
}
