package org.sitaf.core.trajectory;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The signals of one case at consecutive simulation steps.
 *
 * @param firstNanos time of the first sample relative to the call; 0 or negative
 * @param stepNanos time between two samples
 * @param names of the signals
 * @param columns the values of each signal, which are not copied; all of the same length, above 0
 */
public record Trace(long firstNanos, long stepNanos, List<String> names, List<double[]> columns) {
  private static final double NANOS_PER_SECOND = 1e9;

  public Trace {
    names = List.copyOf(names);
    columns = List.copyOf(columns);
    if (stepNanos <= 0 || firstNanos > 0 || names.size() != columns.size() || names.isEmpty()) {
      throw new IllegalArgumentException("a trace needs a time step and one column per signal");
    }
    int count = columns.get(0).length;
    if (count == 0 || columns.stream().anyMatch(c -> c.length != count)) {
      throw new IllegalArgumentException("the signals of a trace need the same number of samples");
    }
  }

  /** The number of samples. */
  public int count() {
    return columns.get(0).length;
  }

  /** Time of a sample relative to the call, in nanoseconds. */
  public long nanos(int sample) {
    return firstNanos + sample * stepNanos;
  }

  /** Time of a sample relative to the call, in seconds. */
  public double seconds(int sample) {
    return nanos(sample) / NANOS_PER_SECOND;
  }

  /** The samples from the call on. */
  Trace fromCall() {
    int before = (int) (-firstNanos / stepNanos);
    if (before == 0) {
      return this;
    }
    List<double[]> after =
        columns.stream().map(c -> java.util.Arrays.copyOfRange(c, before, c.length)).toList();
    return new Trace(firstNanos + before * stepNanos, stepNanos, names, after);
  }

  /** The columns by name. */
  Map<String, double[]> byName() {
    Map<String, double[]> found = new HashMap<>();
    for (int i = 0; i < names.size(); i++) {
      found.put(names.get(i), columns.get(i));
    }
    return found;
  }
}
