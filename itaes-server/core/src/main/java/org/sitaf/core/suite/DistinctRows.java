package org.sitaf.core.suite;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestValue;

/** Rows with different values. The first of several equal ones is kept. */
final class DistinctRows {
  private final Map<List<Value>, List<TestValue>> byValues = new LinkedHashMap<>();

  void addAll(List<List<TestValue>> rows) {
    rows.forEach(row -> byValues.putIfAbsent(row.stream().map(TestValue::value).toList(), row));
  }

  boolean contains(int parameter, Value value) {
    return byValues.keySet().stream().anyMatch(row -> row.get(parameter).equals(value));
  }

  int size() {
    return byValues.size();
  }

  List<List<TestValue>> all() {
    return List.copyOf(byValues.values());
  }
}
