package org.sitaf.core.suite;

import java.util.Collections;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * The second runs of the valid cases for one relation.
 *
 * @param relation name of the relation
 * @param suite the cases with changed inputs, with the numbers of the original cases
 * @param left why the other valid cases have no second run, by case number
 */
public record SecondRun(String relation, TestSuite suite, Map<Integer, Reason> left) {
  public SecondRun {
    Objects.requireNonNull(relation);
    Objects.requireNonNull(suite);
    left = Collections.unmodifiableMap(new TreeMap<>(left));
  }

  /**
   * Why a case has no second run.
   *
   * @param failed whether a change could not be evaluated; otherwise the relation does not apply
   */
  public record Reason(boolean failed, String message) {
    public Reason {
      Objects.requireNonNull(message);
    }
  }
}
