package org.sitaf.core.trajectory;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.RowExpression;
import org.sitaf.core.expression.type.Type;

/** Evaluates an atom at all samples; only where one of its signals has changed. */
final class CompiledAtom {
  private final Expression expression;
  private final Optional<Expression.Comparison> comparison;
  private final List<ListElements> lists;

  /** The columns of a row: numbers, then the elements of lists. */
  private final List<String> signals;

  /** The number of variables of the expression that are signals. */
  private final int variables;

  private final Map<String, List<Integer>> columnsOfLists = new HashMap<>();

  /**
   * @param signals names of all signals that are numbers, and of the time
   * @param sizes of all signals that are lists, by name
   * @throws IllegalArgumentException if it uses an element that a list does not have
   */
  CompiledAtom(Expression expression, Set<String> signals, Map<String, Integer> sizes) {
    this.expression = expression;
    this.comparison = expression.comparison();
    List<String> used =
        new ArrayList<>(
            expression.variables().stream().filter(signals::contains).sorted().toList());
    this.lists =
        expression.variables().stream()
            .filter(sizes::containsKey)
            .sorted()
            .map(list -> ListElements.of(expression, list, sizes.get(list)))
            .toList();
    this.variables = used.size() + lists.size();
    for (ListElements list : lists) {
      columnsOfLists.put(list.list(), list.columns(used.size()));
      used.addAll(list.signals());
    }
    this.signals = List.copyOf(used);
  }

  /** The signals that it uses. */
  List<String> signals() {
    return signals;
  }

  /** The lists whose elements it uses. */
  List<ListElements> lists() {
    return lists;
  }

  /** The signals that a plot or a message shows. */
  List<String> plotted() {
    Set<String> elements = new HashSet<>();
    lists.stream().filter(ListElements::isWhole).forEach(l -> elements.addAll(l.signals()));
    return Stream.concat(
            signals.stream().filter(name -> !elements.contains(name)),
            lists.stream().filter(ListElements::isWhole).flatMap(l -> l.plotted().stream()))
        .toList();
  }

  /**
   * What is wrong with an atom that is no comparison, as far as its type or, if it uses only
   * signals, its value shows; empty if nothing is.
   */
  String problem() {
    if (comparison.isPresent()) {
      return "";
    }
    if (!expression.type().equals(Type.BOOLEAN) && !expression.type().isOpen()) {
      return noTruth();
    }
    if (variables < expression.variables().size()) {
      return "";
    }
    try {
      Object value =
          expression.overRows(signals, columnsOfLists, Map.of()).value(new double[signals.size()]);
      return value instanceof Boolean ? "" : noTruth();
    } catch (EvaluationException e) {
      // It may have a value for other samples.
      return "";
    }
  }

  private String noTruth() {
    return "'" + expression.text() + "' is neither true nor false; compare it, such as == 0.0";
  }

  /**
   * Evaluates the atom.
   *
   * @param columns values of the signals by name
   * @param inputs values of all other variables
   */
  AtomValues values(Map<String, double[]> columns, Map<String, Object> inputs, int count)
      throws EvaluationException {
    List<double[]> used = new ArrayList<>();
    for (String signal : signals) {
      used.add(columns.get(signal));
    }
    boolean[] truths = new boolean[count];
    double[] margins = new double[count];
    double[] row = new double[used.size()];
    Truth truth = new Truth(inputs);
    for (int k = 0; k < count; k++) {
      boolean changed = k == 0;
      for (int i = 0; i < row.length; i++) {
        double value = used.get(i)[k];
        changed |= Double.doubleToRawLongBits(value) != Double.doubleToRawLongBits(row[i]);
        row[i] = value;
      }
      if (changed) {
        truth.evaluate(row);
      }
      truths[k] = truth.holds;
      margins[k] = truth.margin;
    }
    return new AtomValues(truths, margins);
  }

  /** The truth value and the margin at one sample. */
  private final class Truth {
    private final RowExpression whole;
    private final Optional<RowExpression> left;
    private final Optional<RowExpression> right;
    private boolean holds;
    private double margin;

    Truth(Map<String, Object> inputs) {
      whole = expression.overRows(signals, columnsOfLists, inputs);
      left = comparison.map(c -> c.left().overRows(signals, columnsOfLists, inputs));
      right = comparison.map(c -> c.right().overRows(signals, columnsOfLists, inputs));
    }

    void evaluate(double[] row) throws EvaluationException {
      if (left.isPresent() && right.isPresent()) {
        Object first = left.get().value(row);
        Object second = right.get().value(row);
        if (first instanceof Number a && second instanceof Number b) {
          compare(a.doubleValue(), b.doubleValue());
          if (first instanceof Double || second instanceof Double) {
            return;
          }
        } else {
          margin = Double.NaN;
        }
      } else {
        margin = Double.NaN;
      }
      // Also compares whole numbers exactly.
      holds = whole.isTrue(row);
      if (Double.isNaN(margin)) {
        margin = holds ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
      }
    }

    private void compare(double a, double b) {
      // Equal infinities have no difference.
      double difference = a == b ? 0 : b - a;
      String operator = comparison.orElseThrow().operator();
      switch (operator) {
        case "<" -> set(a < b, difference);
        case "<=" -> set(a <= b, difference);
        case ">" -> set(a > b, -difference);
        case ">=" -> set(a >= b, -difference);
        case "==" -> set(a == b, -Math.abs(difference));
        case "!=" -> set(a != b, Math.abs(difference));
        default -> throw new IllegalStateException(operator);
      }
    }

    private void set(boolean truth, double distance) {
      holds = truth;
      // NaN compares with nothing; adding 0 makes a negative zero positive.
      margin =
          Double.isNaN(distance)
              ? truth ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY
              : distance + 0.0;
    }
  }
}
