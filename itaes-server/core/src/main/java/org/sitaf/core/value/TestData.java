package org.sitaf.core.value;

import java.util.List;

/**
 * The values of one test element.
 *
 * @param values without duplicates, numbers in ascending order
 * @param unrepresentable literals of generated values that the type cannot represent
 */
public record TestData(List<TestValue> values, List<String> unrepresentable) {
  public TestData {
    values = List.copyOf(values);
    unrepresentable = List.copyOf(unrepresentable);
  }
}
