package org.sitaf.core.suite.sequence;

import java.util.List;
import org.sitaf.core.value.TestValue;

/** The values of one call; none for an event. */
record StepRow(List<TestValue> values) {
  static final StepRow NONE = new StepRow(List.of());

  StepRow {
    values = List.copyOf(values);
  }

  boolean isValid() {
    return values.stream().allMatch(TestValue::valid);
  }

  List<String> literals() {
    return values.stream().map(v -> v.value().literal()).toList();
  }
}
