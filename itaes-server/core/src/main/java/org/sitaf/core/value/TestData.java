package org.sitaf.core.value;

import java.util.List;

/**
 * The values of one test element.
 *
 * @param values each once, numbers in ascending order
 * @param leftOut spellings of values that the scheme gives and the type cannot hold
 */
public record TestData(List<TestValue> values, List<String> leftOut) {
  public TestData {
    values = List.copyOf(values);
    leftOut = List.copyOf(leftOut);
  }
}
