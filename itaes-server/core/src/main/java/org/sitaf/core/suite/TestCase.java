package org.sitaf.core.suite;

import java.util.List;

/**
 * One test case: an input vector and what is expected of it.
 *
 * @param no from 1, unique in the suite
 * @param valid whether it holds no invalid value
 * @param values literals in the order of the suite's parameters
 * @param expected empty where nothing is expected
 */
public record TestCase(int no, boolean valid, List<String> values, List<ExpectedValue> expected) {
  public TestCase {
    if (no < 1) {
      throw new IllegalArgumentException("case numbers begin at 1, not " + no);
    }
    values = List.copyOf(values);
    expected = List.copyOf(expected);
  }
}
