package org.sitaf.core.trajectory;

import java.util.ArrayList;
import java.util.Arrays;
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
  ListElements {
    used = List.copyOf(used);
  }

  /**
   * The elements that an expression uses.
   *
   * @throws IllegalArgumentException if an index is not one of the list
   */
  static ListElements of(Expression expression, String list, int size) {
    Optional<Set<Long>> indices = expression.indices(list);
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
