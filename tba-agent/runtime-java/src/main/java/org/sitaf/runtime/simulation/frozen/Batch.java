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
 * Worlds that were prepared in one call, one for each combination of values. Every case starts from
 * a reset, so cases with the same values share a world.
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
   * Creates a batch from the response of a call.
   *
   * @param rows the values of each world in the order of the names, each combination once
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

  /** Index of the world with these values; null when there is none. */
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
    // Doubles are compared by their bits, so -0.0 and 0.0 differ.
    return rows.get(row);
  }

  /** Returns a world and marks it as used; empty when it diverged. */
  Optional<FrozenWorld> take(int row, long timeNanos) {
    taken.add(row);
    if (diverged.contains(row)) {
      return Optional.empty();
    }
    int width = layout.columns().size();
    return Optional.of(
        new PreparedWorld(timeNanos, layout, readings.subList(row * width, (row + 1) * width)));
  }

  /** Whether most of its worlds were not used. */
  boolean wasMostlyUnused() {
    return taken.size() * 2 < rows.size();
  }
}
