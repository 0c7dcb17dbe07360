package org.sitaf.runtime.suite;

import java.util.Map;
import java.util.Objects;

/** A step of a sequence: a call with its values, or an event without values. */
public final class TestStep extends TestCase {
  private final int number;
  private final String name;

  /**
   * A step.
   *
   * @param no of the case
   * @param number of the step in the case, from 1
   * @param name of the call or event in the test model
   * @param values literals by parameter of the call
   */
  public TestStep(int no, int number, String name, boolean valid, Map<String, String> values) {
    super(no, valid, values);
    this.number = number;
    this.name = Objects.requireNonNull(name);
  }

  /** Its number in the case, from 1. */
  public int number() {
    return number;
  }

  /** The call or event of the test model. */
  public String name() {
    return name;
  }
}
