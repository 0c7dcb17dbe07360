package org.sitaf.core.trajectory;

import java.util.List;
import java.util.Objects;

/**
 * Where a trajectory condition applies in the trace of a case.
 *
 * @param name of the condition
 * @param fromNanos begin of the interval of the outermost temporal operators, relative to the call
 * @param toNanos its end, at least {@code fromNanos}
 * @param signals that the condition uses, without the time
 */
public record ConditionSpan(String name, long fromNanos, long toNanos, List<String> signals) {
  public ConditionSpan {
    Objects.requireNonNull(name);
    signals = List.copyOf(signals);
    if (toNanos < fromNanos) {
      throw new IllegalArgumentException("the interval of " + name + " ends before it begins");
    }
  }
}
