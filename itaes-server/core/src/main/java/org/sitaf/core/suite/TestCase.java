package org.sitaf.core.suite;

import java.util.List;

/**
 * A test case: input values and expected values of one call, or a sequence of steps.
 *
 * @param no case number from 1, unique in the suite
 * @param valid whether all values are valid, and no step is forbidden
 * @param values literals in the order of the suite's parameters; of a sequence, what is set before
 *     the first step
 * @param expected expected values; may be empty
 * @param steps of a sequence; empty for one call
 */
public record TestCase(
    int no,
    boolean valid,
    List<String> values,
    List<ExpectedValue> expected,
    List<TestStep> steps) {
  public TestCase {
    if (no < 1) {
      throw new IllegalArgumentException("case numbers start at 1, not " + no);
    }
    values = List.copyOf(values);
    expected = List.copyOf(expected);
    steps = List.copyOf(steps);
  }

  /** A case of one call. */
  public TestCase(int no, boolean valid, List<String> values, List<ExpectedValue> expected) {
    this(no, valid, values, expected, List.of());
  }

  /** A copy without expected values. */
  public TestCase withoutExpected() {
    return new TestCase(
        no, valid, values, List.of(), steps.stream().map(TestStep::withoutExpected).toList());
  }

  /** A copy with another number. */
  public TestCase withNumber(int other) {
    return new TestCase(other, valid, values, expected, steps);
  }
}
