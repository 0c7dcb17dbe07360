package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;

/**
 * A test case that the user wants to keep.
 *
 * @param no case number, from 1; 0 if not numbered yet
 * @param values one value per input element, in order
 * @param steps of a sequence; empty for one call
 * @param line line in the document, from 1; 0 if unknown
 */
public record KeptCase(int no, List<Value> values, List<Step> steps, int line) {
  public KeptCase {
    values = List.copyOf(values);
    steps = List.copyOf(steps);
  }

  /** A case of one call. */
  public KeptCase(int no, List<Value> values, int line) {
    this(no, values, List.of(), line);
  }

  /**
   * A step of a kept case.
   *
   * @param name of a call or event
   * @param values one value per input element of the call, in order
   */
  public record Step(String name, List<Value> values) {
    public Step {
      Objects.requireNonNull(name);
      values = List.copyOf(values);
    }
  }
}
