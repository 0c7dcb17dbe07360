package org.sitaf.core.suite;

import java.util.List;

/**
 * A test case: input values and expected values.
 *
 * @param no case number from 1, unique in the suite
 * @param valid whether all values are valid
 * @param values literals in the order of the suite's parameters
 * @param expected expected values; may be empty
 */
public record TestCase(int no, boolean valid, List<String> values, List<ExpectedValue> expected) {
  public TestCase {
    if (no < 1) {
      throw new IllegalArgumentException("case numbers start at 1, not " + no);
    }
    values = List.copyOf(values);
    expected = List.copyOf(expected);
  }
}
