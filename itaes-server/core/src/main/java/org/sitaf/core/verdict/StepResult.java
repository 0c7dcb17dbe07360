package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The result of a step of a sequence.
 *
 * @param name of the call or event in the test model
 * @param afterFailure whether an earlier step of the case failed, so that this verdict may be a
 *     consequence
 * @param values literals in the order of the call's inputs; none for an event
 * @param at simulation time in seconds at which it began, since the first step began; null if it
 *     was not executed
 * @param time of the call; null for an event and if it did not end
 * @param message why the verdict is not PASS; empty otherwise
 */
public record StepResult(
    String name,
    Verdict verdict,
    boolean afterFailure,
    List<String> values,
    List<NamedValue> expected,
    List<NamedValue> actual,
    @Nullable Double at,
    CaseResult.@Nullable ProcessingTime time,
    String message) {
  public StepResult {
    Objects.requireNonNull(name);
    Objects.requireNonNull(verdict);
    values = List.copyOf(values);
    expected = List.copyOf(expected);
    actual = List.copyOf(actual);
    Objects.requireNonNull(message);
  }

  /** The step as messages name it: {@code step 3 (Read)}. */
  public static String label(int number, String name) {
    return "step " + number + " (" + name + ")";
  }
}
