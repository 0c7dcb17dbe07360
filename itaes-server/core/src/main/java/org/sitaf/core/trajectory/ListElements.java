package org.sitaf.core.trajectory;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.sitaf.core.expression.Expression;

/**
 * The elements of a list, such as the ranges of a laser scanner, that an atom uses as signals.
 *
 * @param list name of the list
 * @param size number of its elements
 * @param used indices of the elements in use, ascending
 * @param isWhole whether the atom uses the list other than by constant indices
 */
record ListElements(String list, int size, List<Integer> used, boolean isWhole) {
  /** Largest index of a list of unknown size, and one. */
  private static final int MAX_ELEMENTS = 10_000;

  ListElements {
    used = List.copyOf(used);
  }

  /**
   * The elements that an expression uses.
   *
   * @param size {@link TrajectoryConditions#ANY_LENGTH} if it is not known before the run
   * @throws IllegalArgumentException if an index is not one of the list, or if a list of unknown
   *     size is used as a whole
   */
  static ListElements of(Expression expression, String list, int size) {
    Optional<Set<Long>> indices = expression.indices(list);
    if (size == TrajectoryConditions.ANY_LENGTH) {
      return ofAnyLength(indices.orElse(Set.of()), list);
    }
    if (indices.isEmpty()) {
      return new ListElements(list, size, IntStream.range(0, size).boxed().toList(), true);
    }
    List<Integer> used = new ArrayList<>();
    for (long index : indices.get()) {
      if (index < 0 || index >= size) {
        throw new IllegalArgumentException(
            "%s[%d] does not exist; the last element is %s"
                .formatted(list, index, element(list, size - 1)));
      }
      used.add((int) index);
    }
    return new ListElements(list, size, used, false);
  }

  private static ListElements ofAnyLength(Set<Long> indices, String list) {
    if (indices.isEmpty()) {
      throw new IllegalArgumentException(
          "each message gives the length of '%s'; use single elements such as %s"
              .formatted(list, element(list, 0)));
    }
    long last = Collections.max(indices);
    if (Collections.min(indices) < 0 || last >= MAX_ELEMENTS) {
      throw new IllegalArgumentException(
          "an index of '%s' must be from 0 to %d".formatted(list, MAX_ELEMENTS - 1));
    }
    List<Integer> used = indices.stream().map(Long::intValue).sorted().toList();
    return new ListElements(list, (int) last + 1, used, false);
  }

  /** The name of an element. */
  static String element(String list, int index) {
    return list + "[" + index + "]";
  }

  /** The signals that are sampled. */
  List<String> signals() {
    return used.stream().map(index -> element(list, index)).toList();
  }

  /** The signals that a plot shows: the elements, or the smallest and the largest of all. */
  List<String> plotted() {
    return isWhole ? List.of(smallest(), largest()) : signals();
  }

  /** The columns of the elements in a row that holds them from a column on; -1 for the others. */
  List<Integer> columns(int first) {
    Integer[] columns = new Integer[size];
    Arrays.fill(columns, -1);
    for (int i = 0; i < used.size(); i++) {
      columns[used.get(i)] = first + i;
    }
    return List.of(columns);
  }

  /** Adds the smallest and the largest element of each sample to columns by name. */
  void addExtremes(Map<String, double[]> columns, int count) {
    if (!isWhole || columns.containsKey(smallest())) {
      return;
    }
    double[] low = new double[count];
    double[] high = new double[count];
    Arrays.fill(low, Double.POSITIVE_INFINITY);
    Arrays.fill(high, Double.NEGATIVE_INFINITY);
    for (String signal : signals()) {
      double[] values = columns.get(signal);
      for (int k = 0; k < count; k++) {
        low[k] = Math.min(low[k], values[k]);
        high[k] = Math.max(high[k], values[k]);
      }
    }
    columns.put(smallest(), low);
    columns.put(largest(), high);
  }

  private String smallest() {
    return "min(" + list + ")";
  }

  private String largest() {
    return "max(" + list + ")";
  }
}
