package org.sitaf.core.suite;

import java.util.List;
import java.util.Objects;

/**
 * A step of a sequence: a call, or an event of the world.
 *
 * @param name of the call or event
 * @param valid false if the call is forbidden here or has an invalid value
 * @param values literals in the order of the call's parameters; none for an event
 * @param expected expected values; may be empty
 */
public record TestStep(
    String name, boolean valid, List<String> values, List<ExpectedValue> expected) {
  public TestStep {
    Objects.requireNonNull(name);
    values = List.copyOf(values);
    expected = List.copyOf(expected);
  }

  /** A copy without expected values. */
  public TestStep withoutExpected() {
    return new TestStep(name, valid, values, List.of());
  }
}
