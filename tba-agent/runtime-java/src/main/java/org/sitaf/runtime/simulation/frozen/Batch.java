package org.sitaf.runtime.simulation.frozen;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sitaf.sim.v1.PrepareManyResponse;

/** Cases that were prepared in one call, in the order of the suite. */
final class Batch {
  private final Layout layout;
  private final List<String> names;
  private final long settleNanos;
  private final List<double[]> rows;
  private final List<Double> readings;
  private final Set<Integer> diverged;
  private int next;
  private int taken;

  Batch(
      Layout layout,
      List<String> names,
      long settleNanos,
      List<double[]> rows,
      PrepareManyResponse prepared) {
    this.layout = layout;
    this.names = names;
    this.settleNanos = settleNanos;
    this.rows = List.copyOf(rows);
    this.readings = prepared.getReadingsList();
    this.diverged = new HashSet<>(prepared.getDivergedCasesList());
  }

  /**
   * Goes on to the first case of these values, and says whether there is one. Cases before it did
   * not get as far as their preparation.
   */
  boolean finds(Map<String, Double> parameters, long settle) {
    if (settle != settleNanos || parameters.size() != names.size()) {
      return false;
    }
    for (int row = next; row < rows.size(); row++) {
      if (holds(rows.get(row), parameters)) {
        next = row;
        return true;
      }
    }
    return false;
  }

  /** The world of the case that was found; empty when it diverged. */
  Optional<FrozenWorld> take(long timeNanos) {
    int row = next++;
    taken++;
    if (diverged.contains(row)) {
      return Optional.empty();
    }
    int width = layout.columns().size();
    return Optional.of(
        new PreparedWorld(timeNanos, layout, readings.subList(row * width, (row + 1) * width)));
  }

  /** Whether most of it was of no use. */
  boolean wasInVain() {
    return taken * 2 < rows.size();
  }

  private boolean holds(double[] row, Map<String, Double> parameters) {
    for (int i = 0; i < row.length; i++) {
      Double value = parameters.get(names.get(i));
      // Bits, not numbers: -0.0 is another value than 0.0.
      if (value == null || Double.doubleToLongBits(value) != Double.doubleToLongBits(row[i])) {
        return false;
      }
    }
    return true;
  }
}
