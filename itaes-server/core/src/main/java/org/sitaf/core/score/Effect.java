package org.sitaf.core.score;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.verdict.CaseRecord;

/**
 * What a fault changes in one case, or in one step of a case.
 *
 * @param no number of the case; 0 if the case is not in the suite
 * @param label names it in messages: {@code case 3} or {@code case 3, step 4 (Read)}
 * @param values of the case or step
 * @param expected values of the case or step
 * @param without the record without the fault
 * @param with the record with the fault
 * @param passes whether the case passes without the fault
 */
public record Effect(
    int no,
    String label,
    List<String> values,
    List<ExpectedValue> expected,
    CaseRecord without,
    CaseRecord with,
    boolean passes) {
  public Effect {
    values = List.copyOf(values);
    expected = List.copyOf(expected);
  }

  /** The literal of an output with the fault; null if there is none. */
  @Nullable String changed(String output) {
    return value(with, output);
  }

  /** The literal of an output without the fault; null if there is none. */
  @Nullable String original(String output) {
    return value(without, output);
  }

  /** Whether the value of an output is changed. */
  boolean changes(String output) {
    String one = original(output);
    String other = changed(output);
    return one == null ? other != null : !one.equals(other);
  }

  private static @Nullable String value(CaseRecord record, String output) {
    return record.actual().stream()
        .filter(a -> a.output().equals(output))
        .map(a -> a.literal())
        .findFirst()
        .orElse(null);
  }
}
