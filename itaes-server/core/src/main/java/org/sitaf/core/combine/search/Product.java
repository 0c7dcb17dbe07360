package org.sitaf.core.combine.search;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;
import org.sitaf.core.combine.feasible.Propagation;

/** Enumerates all allowed combinations in ascending order. Propagation prunes branches. */
public final class Product {
  private final Symbols symbols;
  private final Feasibility feasibility;
  private final Set<List<Integer>> present = new HashSet<>();
  private final List<int[]> rows = new ArrayList<>();

  /** Creates an enumeration. */
  public Product(Symbols symbols, Feasibility feasibility) {
    this.symbols = symbols;
    this.feasibility = feasibility;
  }

  /** Returns the allowed rows except the seeds. */
  public List<int[]> rows(List<Row> seeds) {
    for (Row seed : seeds) {
      present.add(key(seed.values()));
    }
    if (!feasibility.contradiction()) {
      extend(new Row(symbols), 0);
    }
    return rows;
  }

  private static List<Integer> key(int[] values) {
    return java.util.Arrays.stream(values).boxed().toList();
  }

  private void extend(Row row, int column) {
    if (column == symbols.columns()) {
      if (present.isEmpty() || !present.contains(key(row.values()))) {
        rows.add(row.values());
      }
      return;
    }
    Interruption.check();
    Propagation propagation = feasibility.propagation();
    boolean constrained = feasibility.rules().isConstrained(column);
    for (int v = 0; v < symbols.levels(column); v++) {
      int mark = propagation.mark();
      row.set(column, v);
      if (!constrained
          || (propagation.choose(column, v) && feasibility.rules().allow(row, column, v))) {
        extend(row, column + 1);
      }
      propagation.undo(mark);
    }
    row.set(column, Row.FREE);
  }
}
