package org.sitaf.core.expression;

import dev.cel.runtime.CelVariableResolver;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An expression for many evaluations, each with a row of numbers. Immutable, so several threads can
 * use it.
 */
public final class RowExpression {
  private final Expression expression;
  private final Map<String, Integer> columns = new HashMap<>();
  private final Map<String, Object> fixed;

  RowExpression(Expression expression, List<String> columns, Map<String, Object> fixed) {
    this.expression = expression;
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
      return column == null ? Optional.ofNullable(fixed.get(name)) : Optional.of(row[column]);
    };
  }
}
