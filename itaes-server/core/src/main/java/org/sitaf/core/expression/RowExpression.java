package org.sitaf.core.expression;

import dev.cel.runtime.CelVariableResolver;
import java.util.AbstractList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.RandomAccess;

/**
 * An expression for many evaluations, each with a row of numbers. Immutable, so several threads can
 * use it.
 */
public final class RowExpression {
  private final Expression expression;
  private final Map<String, Integer> columns = new HashMap<>();
  private final Map<String, List<Integer>> lists;
  private final Map<String, Object> fixed;

  RowExpression(
      Expression expression,
      List<String> columns,
      Map<String, List<Integer>> lists,
      Map<String, Object> fixed) {
    this.expression = expression;
    this.lists = Map.copyOf(lists);
    this.fixed = Map.copyOf(fixed);
    for (int i = 0; i < columns.size(); i++) {
      this.columns.put(columns.get(i), i);
    }
  }

  /**
   * Evaluates to a number; 1 for true and 0 for false.
   *
   * @param row values in the order of the columns
   * @throws EvaluationException if the evaluation fails or the result is neither a number nor a
   *     boolean
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public double number(double[] row) throws EvaluationException {
    Object value = expression.evaluate(resolver(row));
    if (value instanceof Number number) {
      return number.doubleValue();
    }
    if (value instanceof Boolean truth) {
      return truth ? 1 : 0;
    }
    throw new EvaluationException("'" + expression.text() + "' is not a number");
  }

  /**
   * Evaluates to a value: Long, Double, Boolean, String, List or Map.
   *
   * @param row values in the order of the columns
   * @throws EvaluationException if the evaluation fails
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public Object value(double[] row) throws EvaluationException {
    return expression.evaluate(resolver(row));
  }

  /**
   * Evaluates to a boolean.
   *
   * @param row values in the order of the columns
   * @throws EvaluationException if the evaluation fails or the result is not a boolean
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public boolean isTrue(double[] row) throws EvaluationException {
    if (expression.evaluate(resolver(row)) instanceof Boolean truth) {
      return truth;
    }
    throw new EvaluationException("'" + expression.text() + "' is neither true nor false");
  }

  private CelVariableResolver resolver(double[] row) {
    return name -> {
      Integer column = columns.get(name);
      if (column != null) {
        return Optional.of(row[column]);
      }
      List<Integer> elements = lists.get(name);
      return elements == null
          ? Optional.ofNullable(fixed.get(name))
          : Optional.of(new Elements(elements, row));
    };
  }

  /** The elements of a list in a row. */
  private static final class Elements extends AbstractList<Double> implements RandomAccess {
    private final List<Integer> columns;
    private final double[] row;

    Elements(List<Integer> columns, double[] row) {
      this.columns = columns;
      this.row = row;
    }

    @Override
    public Double get(int index) {
      int column = columns.get(index);
      return column < 0 ? Double.NaN : row[column];
    }

    @Override
    public int size() {
      return columns.size();
    }
  }
}
