package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.value.TestValue;

/** The values of one call; none for an event. */
record StepRow(List<TestValue> values) {
  static final StepRow NONE = new StepRow(List.of());

  StepRow {
    values = List.copyOf(values);
  }

  /**
   * The row of a call.
   *
   * @param literals values of the inputs of the call's model
   * @param valid whether all of them are known to be valid
   * @throws IllegalArgumentException if their number is another one, or one is not of its type
   */
  static StepRow of(TestModel model, List<String> literals, boolean valid, InputValidity validity) {
    if (literals.size() != model.inputs().size()) {
      throw new IllegalArgumentException(
          literals.size() + " values for " + model.inputs().size() + " inputs of " + model.name());
    }
    List<TestValue> values = new ArrayList<>();
    for (int i = 0; i < literals.size(); i++) {
      InputElement input = model.inputs().get(i);
      String literal = literals.get(i);
      values.add(new TestValue(input.value(literal), valid || validity.isValid(i, literal)));
    }
    return new StepRow(values);
  }

  boolean isValid() {
    return values.stream().allMatch(TestValue::valid);
  }

  List<String> literals() {
    return values.stream().map(v -> v.value().literal()).toList();
  }
}
