package org.sitaf.core.combine;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Searches an allowed row that contains given values by trying all values of the other parameters.
 */
final class ExhaustiveSearch {
  private final int[] levels;
  private final List<Constraint> constraints;
  private final List<List<Constraint>> constraintsByParameter = new ArrayList<>();

  ExhaustiveSearch(CombinationProblem problem) {
    this.levels = problem.levels();
    this.constraints = problem.constraints();
    for (int p = 0; p < levels.length; p++) {
      int parameter = p;
      constraintsByParameter.add(
          constraints.stream()
              .filter(c -> Arrays.stream(c.parameters()).anyMatch(q -> q == parameter))
              .toList());
    }
  }

  /** Whether an allowed row contains these values. */
  boolean finds(int[] parameters, int[] values) {
    int[] row = new int[levels.length];
    Arrays.fill(row, CombinationProblem.FREE);
    for (int i = 0; i < parameters.length; i++) {
      row[parameters[i]] = values[i];
    }
    for (Constraint constraint : constraints) {
      if (!isSatisfied(constraint, row)) {
        return false;
      }
    }
    return finds(row, order(parameters), 0);
  }

  /** The parameters of constraints, beginning with those related to the given ones. */
  private List<Integer> order(int[] from) {
    Set<Integer> order = new LinkedHashSet<>();
    ArrayDeque<Integer> open = new ArrayDeque<>();
    Arrays.stream(from).forEach(open::add);
    for (Constraint constraint : constraints) {
      Arrays.stream(constraint.parameters()).forEach(open::addLast);
    }
    Set<Integer> seen = new LinkedHashSet<>();
    while (!open.isEmpty()) {
      int p = open.removeFirst();
      if (seen.add(p)) {
        order.add(p);
        for (Constraint constraint : constraintsByParameter.get(p)) {
          Arrays.stream(constraint.parameters()).forEach(open::addFirst);
        }
      }
    }
    return List.copyOf(order);
  }

  private boolean finds(int[] row, List<Integer> order, int depth) {
    if (depth == order.size()) {
      return true;
    }
    int p = order.get(depth);
    if (row[p] >= 0) {
      return finds(row, order, depth + 1);
    }
    for (int v = 0; v < levels[p]; v++) {
      row[p] = v;
      boolean satisfied = constraintsByParameter.get(p).stream().allMatch(c -> isSatisfied(c, row));
      if (satisfied && finds(row, order, depth + 1)) {
        return true;
      }
    }
    row[p] = CombinationProblem.FREE;
    return false;
  }

  /** Whether a constraint is satisfied or undecided. */
  private static boolean isSatisfied(Constraint constraint, int[] row) {
    int[] values = Arrays.stream(constraint.parameters()).map(q -> row[q]).toArray();
    return Arrays.stream(values).anyMatch(v -> v < 0) || constraint.allowed().test(values);
  }
}
