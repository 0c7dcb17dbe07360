package org.sitaf.core.combine.construction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/**
 * Searches covering arrays with the same number of values in all columns, developed from a few
 * starter rows by a permutation group. Several groups compete in increasingly long searches for
 * fewer rows than the best.
 */
final class GroupDevelopment {
  /** Operations of the first attempt of each plan; doubled in each round. */
  private static final long FIRST_SLICE = 1_000_000;

  private final int strength;
  private final int values;
  private final int columns;
  private final SeededRandom random;
  private int @Nullable [][] nearest;
  private int nearestMissed = Integer.MAX_VALUE;
  private final List<Plan> plans = new ArrayList<>();

  GroupDevelopment(int strength, int values, int columns, SeededRandom random) {
    this.strength = strength;
    this.values = values;
    this.columns = columns;
    this.random = random;
    for (SymbolGroup group : SymbolGroup.of(values)) {
      int[] orbits = group.orbits(strength);
      for (List<Integer> constants : group.constantRows()) {
        plans.add(new Plan(group, orbits, constants));
      }
    }
  }

  /**
   * Searches an array with fewer than {@code size} rows; null if none was found within the budget.
   */
  int @Nullable [][] below(int size, Budget budget) {
    int best = size;
    int[][] found = null;
    long slice = FIRST_SLICE;
    while (!budget.isExhausted()) {
      boolean anyPlan = false;
      for (Plan plan : plans) {
        while (!budget.isExhausted() && plan.canBeat(best)) {
          anyPlan = true;
          Budget attempt = new Budget(Math.min(slice, budget.remaining()));
          int[][] rows = plan.attempt(plan.starters(best), attempt);
          budget.spend(attempt.total() - attempt.remaining());
          if (rows == null) {
            break;
          }
          found = rows;
          best = rows.length;
          nearest = null;
          nearestMissed = Integer.MAX_VALUE;
        }
      }
      if (!anyPlan) {
        break;
      }
      slice *= 2;
    }
    return found;
  }

  /**
   * After {@link #below}: an array with fewer rows that misses few tuples; null if there is none.
   */
  int @Nullable [][] nearest() {
    return nearest;
  }

  /** A group, and the constant rows that are added to the starter rows. */
  private final class Plan {
    private final SymbolGroup group;
    private final int[] orbits;
    private final List<Integer> constants;
    private final boolean[] covered;
    private final int least;

    Plan(SymbolGroup group, int[] orbits, List<Integer> constants) {
      this.group = group;
      this.orbits = orbits;
      this.constants = constants;
      this.covered = new boolean[Arrays.stream(orbits).max().orElse(0) + 1];
      int step = 0;
      for (int i = 0, place = 1; i < strength; i++, place *= values) {
        step += place;
      }
      int free = 0;
      for (int value : constants) {
        if (!covered[orbits[value * step]]) {
          covered[orbits[value * step]] = true;
          free++;
        }
      }
      this.least = covered.length - free;
    }

    int starters(int best) {
      return (best - 1 - constants.size()) / group.order();
    }

    boolean canBeat(int best) {
      return starters(best) >= least;
    }

    int @Nullable [][] attempt(int starters, Budget budget) {
      StarterSearch search =
          new StarterSearch(strength, columns, values, orbits, covered, starters, random);
      if (search.run(budget)) {
        return develop(search.rows());
      }
      int missed = search.nearestOpen() * group.order();
      if (missed < nearestMissed) {
        nearestMissed = missed;
        nearest = develop(search.nearest());
      }
      return null;
    }

    private int[][] develop(int[][] starters) {
      TreeSet<int[]> rows = new TreeSet<>(Comparator.comparing((int[] a) -> a, Arrays::compare));
      for (int[] starter : starters) {
        for (int[] map : group.elements()) {
          rows.add(Arrays.stream(starter).map(x -> map[x]).toArray());
        }
      }
      for (int value : constants) {
        int[] row = new int[columns];
        Arrays.fill(row, value);
        rows.add(row);
      }
      return rows.toArray(int[][]::new);
    }
  }
}
