package org.sitaf.core.combine.construction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/** Selects an algebraic construction for given levels. */
public final class Constructions {
  private static final int MAX_ORDER = 64;
  private static final long MAX_ROWS = 200_000;

  /**
   * A construction with more rows than this multiple of the lower bound is not better than greedy
   * growth.
   */
  private static final double MAX_BOUND_FACTOR = 3;

  private static final int MAX_VALUES = 16;
  private static final double MAX_TUPLES = 20_000;

  /**
   * Minimum share of columns with the maximum number of values; below, folding wastes too many
   * rows.
   */
  private static final double MIN_EQUAL_SHARE = 0.75;

  private Constructions() {}

  /**
   * Constructs an array directly if a construction close to the lower bound is known. Rows may
   * repeat; callers must check the coverage.
   *
   * @param levels number of values per column, at least 2
   */
  public static Optional<List<int[]>> direct(int strength, int[] levels) {
    int most = Arrays.stream(levels).max().orElse(0);
    if (strength < 2 || most > MAX_ORDER) {
      return Optional.empty();
    }
    double limit = Math.min(MAX_ROWS, MAX_BOUND_FACTOR * product(levels, strength));
    Optional<int[][]> array = orthogonal(strength, most, levels.length, limit);
    if (array.isEmpty() && strength == 3) {
      array = doubled(most, levels.length, limit);
    }
    return array.map(rows -> fold(rows, levels));
  }

  private static Optional<int[][]> orthogonal(int strength, int values, int columns, double limit) {
    int order = GaloisField.orderFrom(values);
    while (OrthogonalArray.columns(strength, order) < columns && order <= MAX_ORDER) {
      order = GaloisField.orderFrom(order + 1);
    }
    return Math.pow(order, strength) > limit
        ? Optional.empty()
        : OrthogonalArray.of(strength, order, columns);
  }

  /**
   * Doubles the number of columns at strength three (M. Chateauneuf, D. Kreher, On the state of
   * strength-three covering arrays, 2002): concatenates each row of an array of strength three with
   * itself, and each row of an array of strength two with itself, shifted by every value except
   * zero.
   */
  private static Optional<int[][]> doubled(int values, int columns, double limit) {
    int half = (columns + 1) / 2;
    Optional<int[][]> triples = orthogonal(3, values, half, limit);
    Optional<int[][]> pairs = orthogonal(2, values, half, limit);
    if (triples.isEmpty() || pairs.isEmpty()) {
      return Optional.empty();
    }
    int[] halves = new int[half];
    Arrays.fill(halves, values);
    List<int[]> rows = new ArrayList<>();
    for (int[] row : fold(triples.get(), halves)) {
      rows.add(concatenate(row, 0, values, columns));
    }
    for (int[] row : fold(pairs.get(), halves)) {
      for (int shift = 1; shift < values; shift++) {
        rows.add(concatenate(row, shift, values, columns));
      }
    }
    return rows.size() > limit ? Optional.empty() : Optional.of(rows.toArray(int[][]::new));
  }

  private static int[] concatenate(int[] row, int shift, int values, int columns) {
    int[] whole = Arrays.copyOf(row, columns);
    for (int c = row.length; c < columns; c++) {
      whole[c] = (row[c - row.length] + shift) % values;
    }
    return whole;
  }

  /**
   * The result of a search over groups.
   *
   * @param array a complete array with fewer rows than requested, if one was found
   * @param nearMiss an array with even fewer rows that misses some tuples
   */
  public record SearchResult(Optional<List<int[]>> array, Optional<List<int[]>> nearMiss) {}

  /**
   * Searches an array with fewer rows than {@code size} that is developed from a group.
   *
   * @param levels number of values per column, at least 2; must be mostly equal
   */
  public static SearchResult develop(
      int strength, int[] levels, int size, SeededRandom random, Budget budget) {
    int most = Arrays.stream(levels).max().orElse(0);
    long equal = Arrays.stream(levels).filter(n -> n == most).count();
    boolean fits = strength >= 2 && most <= MAX_VALUES && Math.pow(most, strength) <= MAX_TUPLES;
    if (!fits || levels.length <= strength || equal < MIN_EQUAL_SHARE * levels.length) {
      return new SearchResult(Optional.empty(), Optional.empty());
    }
    GroupDevelopment search = new GroupDevelopment(strength, most, levels.length, random);
    int[][] rows = search.below(size, budget);
    return new SearchResult(
        Optional.ofNullable(rows).map(array -> fold(array, levels)),
        Optional.ofNullable(search.nearest()).map(array -> fold(array, levels)));
  }

  /** The product of the largest levels: a lower bound of the number of rows. */
  private static double product(int[] levels, int strength) {
    int[] sorted = levels.clone();
    Arrays.sort(sorted);
    double product = 1;
    for (int i = Math.max(0, sorted.length - strength); i < sorted.length; i++) {
      product *= sorted[i];
    }
    return product;
  }

  /** Replaces values that exceed the number of values of their column. */
  private static List<int[]> fold(int[][] rows, int[] levels) {
    for (int r = 0; r < rows.length; r++) {
      for (int c = 0; c < levels.length; c++) {
        if (rows[r][c] >= levels[c]) {
          rows[r][c] = (r + rows[r][c]) % levels[c];
        }
      }
    }
    return List.of(rows);
  }
}
