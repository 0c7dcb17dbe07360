package org.sitaf.core.combine.construction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/**
 * Searches starter rows that a group of symbol permutations develops into a covering array: each
 * set of columns must cover every orbit of the group on tuples. The search space shrinks by the
 * order of the group (M. Chateauneuf, C. Colbourn, D. Kreher: Covering arrays of strength three,
 * 1999; K. Meagher, B. Stevens: Group construction of covering arrays, 2005).
 */
final class StarterSearch {
  private static final int TENURE = 3;
  private static final int RANDOM_MOVE_INTERVAL = 300;

  private final int values;
  private final int columns;
  private final int strength;
  private final int[] orbitOf;
  private final int orbits;
  private final int[][] sets;

  /**
   * For each column and each set that contains it: the set, the stride of the column, then column
   * and stride of the other columns.
   */
  private final int[][] through;

  private final int[][] rows;
  private final long[][] touched;
  private final int[] counts;
  private final int[] open;
  private final int[] placeOf;
  private int openSize;
  private final int[][] nearest;
  private int nearestOpen = Integer.MAX_VALUE;
  private long step = TENURE + 1;
  private final SeededRandom random;

  /**
   * Starts a search for {@code size} starter rows.
   *
   * @param covered orbits that are already covered
   */
  StarterSearch(
      int strength,
      int columns,
      int values,
      int[] orbitOf,
      boolean[] covered,
      int size,
      SeededRandom random) {
    this.strength = strength;
    this.columns = columns;
    this.values = values;
    this.orbitOf = orbitOf;
    this.orbits = covered.length;
    this.random = random;
    this.sets = sets();
    this.through = new int[columns][];
    for (int c = 0; c < columns; c++) {
      through[c] = through(c);
    }
    this.counts = new int[sets.length * orbits];
    this.open = new int[counts.length];
    this.placeOf = new int[counts.length];
    for (int i = 0; i < counts.length; i++) {
      if (covered[i % orbits]) {
        counts[i] = 1 << 29;
      } else {
        placeOf[i] = openSize;
        open[openSize++] = i;
      }
    }
    this.rows = new int[size][columns];
    this.nearest = new int[size][];
    this.touched = new long[size][columns];
    for (int[] row : rows) {
      for (int c = 0; c < columns; c++) {
        row[c] = random.nextInt(values);
      }
      for (int s = 0; s < sets.length; s++) {
        count(s * orbits + orbitOf[code(row, sets[s])], 1);
      }
    }
  }

  private int[][] sets() {
    List<int[]> all = new ArrayList<>();
    int[] set = new int[strength];
    for (int i = 0; i < strength; i++) {
      set[i] = i;
    }
    while (true) {
      all.add(set.clone());
      int i = strength - 1;
      while (i >= 0 && set[i] == columns - strength + i) {
        i--;
      }
      if (i < 0) {
        return all.toArray(int[][]::new);
      }
      set[i]++;
      for (int j = i + 1; j < strength; j++) {
        set[j] = set[j - 1] + 1;
      }
    }
  }

  private int[] through(int column) {
    List<Integer> parts = new ArrayList<>();
    for (int s = 0; s < sets.length; s++) {
      int at = Arrays.binarySearch(sets[s], column);
      if (at < 0) {
        continue;
      }
      parts.add(s * orbits);
      parts.add(stride(at));
      for (int i = 0; i < strength; i++) {
        if (i != at) {
          parts.add(sets[s][i]);
          parts.add(stride(i));
        }
      }
    }
    return parts.stream().mapToInt(Integer::intValue).toArray();
  }

  private int stride(int place) {
    int stride = 1;
    for (int i = 0; i < place; i++) {
      stride *= values;
    }
    return stride;
  }

  private int code(int[] row, int[] set) {
    int code = 0;
    for (int i = strength - 1; i >= 0; i--) {
      code = code * values + row[set[i]];
    }
    return code;
  }

  private void count(int index, int by) {
    int n = counts[index] + by;
    counts[index] = n;
    if (n == 1 && by > 0) {
      int last = open[--openSize];
      open[placeOf[index]] = last;
      placeOf[last] = placeOf[index];
    } else if (n == 0 && by < 0) {
      placeOf[index] = openSize;
      open[openSize++] = index;
    }
  }

  /** Runs the search. Returns whether the rows cover all orbits. */
  boolean run(Budget budget) {
    nearestOpen = Integer.MAX_VALUE;
    while (openSize > 0 && !budget.isExhausted()) {
      if (openSize < nearestOpen) {
        nearestOpen = openSize;
        for (int r = 0; r < rows.length; r++) {
          nearest[r] = rows[r].clone();
        }
      }
      force(open[random.nextInt(openSize)], budget);
    }
    return openSize == 0;
  }

  int[][] rows() {
    return rows;
  }

  /** The rows that missed the fewest orbits in {@link #run}. */
  int[][] nearest() {
    return nearest;
  }

  /** The number of orbits that the nearest rows missed. */
  int nearestOpen() {
    return nearestOpen;
  }

  private void force(int target, Budget budget) {
    step++;
    int[] set = sets[target / orbits];
    int orbit = target % orbits;
    int bestRow = -1;
    int bestColumn = -1;
    int bestValue = -1;
    int most = Integer.MIN_VALUE;
    long oldest = Long.MAX_VALUE;
    int evaluated = 0;
    boolean randomMove = random.nextInt(RANDOM_MOVE_INTERVAL) == 0;
    for (int r = 0; r < rows.length && !randomMove; r++) {
      int code = code(rows[r], set);
      for (int i = 0, stride = 1; i < strength; i++, stride *= values) {
        int c = set[i];
        if (step - touched[r][c] <= TENURE) {
          continue;
        }
        int base = code - stride * rows[r][c];
        for (int v = 0; v < values; v++) {
          if (orbitOf[base + stride * v] == orbit) {
            int delta = delta(rows[r], c, v);
            evaluated++;
            if (delta > most || (delta == most && touched[r][c] < oldest)) {
              most = delta;
              oldest = touched[r][c];
              bestRow = r;
              bestColumn = c;
              bestValue = v;
            }
          }
        }
      }
    }
    budget.spend(
        (long) (evaluated + 3) * through[0].length + (long) rows.length * strength * values);
    if (bestRow < 0) {
      forceAnywhere(set, orbit);
    } else {
      change(bestRow, bestColumn, bestValue);
    }
  }

  private void forceAnywhere(int[] set, int orbit) {
    int row = random.nextInt(rows.length);
    int code = random.nextInt(orbitOf.length);
    while (orbitOf[code] != orbit) {
      code = code + 1 == orbitOf.length ? 0 : code + 1;
    }
    for (int i = 0; i < strength; i++, code /= values) {
      change(row, set[i], code % values);
    }
  }

  private int delta(int[] row, int column, int value) {
    int[] parts = through[column];
    int before = row[column];
    int delta = 0;
    int i = 0;
    while (i < parts.length) {
      int base = parts[i];
      int stride = parts[i + 1];
      int rest = 0;
      i += 2;
      for (int j = 1; j < strength; j++, i += 2) {
        rest += row[parts[i]] * parts[i + 1];
      }
      int from = orbitOf[rest + stride * before];
      int to = orbitOf[rest + stride * value];
      if (from != to) {
        if (counts[base + to] == 0) {
          delta++;
        }
        if (counts[base + from] == 1) {
          delta--;
        }
      }
    }
    return delta;
  }

  private void change(int r, int column, int value) {
    int[] row = rows[r];
    int before = row[column];
    int[] parts = through[column];
    int i = 0;
    while (i < parts.length) {
      int base = parts[i];
      int stride = parts[i + 1];
      int rest = 0;
      i += 2;
      for (int j = 1; j < strength; j++, i += 2) {
        rest += row[parts[i]] * parts[i + 1];
      }
      int from = orbitOf[rest + stride * before];
      int to = orbitOf[rest + stride * value];
      if (from != to) {
        count(base + from, -1);
        count(base + to, 1);
      }
    }
    row[column] = value;
    touched[r][column] = step;
  }
}
