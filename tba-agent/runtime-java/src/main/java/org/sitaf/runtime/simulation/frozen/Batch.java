package org.sitaf.runtime.simulation.frozen;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.sim.v1.PrepareManyResponse;

/**
 * Worlds that were prepared in one call, one for each combination of values: every case begins from
 * a clean reset, so that cases with the same values find the same world.
 */
final class Batch {
  private final Layout layout;
  private final List<String> names;
  private final long settleNanos;
  private final Map<List<Double>, Integer> rows = new LinkedHashMap<>();
  private final List<Double> readings;
  private final Set<Integer> diverged;
  private final Set<Integer> taken = new HashSet<>();

  /**
   * What a call brought.
   *
   * @param rows the values of each world by the names, each combination once
   */
  Batch(
      Layout layout,
      List<String> names,
      long settleNanos,
      List<List<Double>> rows,
      PrepareManyResponse prepared) {
    this.layout = layout;
    this.names = names;
    this.settleNanos = settleNanos;
    rows.forEach(row -> this.rows.put(row, this.rows.size()));
    this.readings = prepared.getReadingsList();
    this.diverged = new HashSet<>(prepared.getDivergedCasesList());
  }

  /** Which world has these values; null where none has. */
  @Nullable Integer find(Map<String, Double> parameters, long settle) {
    if (settle != settleNanos || parameters.size() != names.size()) {
      return null;
    }
    List<Double> row = new ArrayList<>(names.size());
    for (String name : names) {
      Double value = parameters.get(name);
      if (value == null) {
        return null;
      }
      row.add(value);
    }
    // Doubles are equal by their bits: -0.0 is another value than 0.0.
    return rows.get(row);
  }

  /** A world; empty when it diverged. */
  Optional<FrozenWorld> take(int row, long timeNanos) {
    taken.add(row);
    if (diverged.contains(row)) {
      return Optional.empty();
    }
    int width = layout.columns().size();
    return Optional.of(
        new PreparedWorld(timeNanos, layout, readings.subList(row * width, (row + 1) * width)));
  }

  /** Whether most of it was of no use. */
  boolean wasInVain() {
    return taken.size() * 2 < rows.size();
  }
}
