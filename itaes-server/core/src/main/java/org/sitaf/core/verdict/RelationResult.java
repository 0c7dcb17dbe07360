package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;

/**
 * The result of one relation in one case.
 *
 * @param values inputs of the second run, in the order of the suite's parameters; empty if there
 *     was none
 * @param actual outputs of the second run, or its exception
 * @param message why the outcome is not PASS; empty otherwise
 */
public record RelationResult(
    String name, Outcome outcome, List<String> values, List<NamedValue> actual, String message) {
  public RelationResult {
    Objects.requireNonNull(name);
    Objects.requireNonNull(outcome);
    values = List.copyOf(values);
    actual = List.copyOf(actual);
    Objects.requireNonNull(message);
  }

  /** How the relation was judged. */
  public enum Outcome {
    PASS,
    /** The relation is broken. */
    FAIL,
    /** A run failed, or an expression cannot be evaluated. */
    ERROR,
    /** The changed inputs violate a pre-condition or do not fit their type. */
    SKIPPED
  }
}
