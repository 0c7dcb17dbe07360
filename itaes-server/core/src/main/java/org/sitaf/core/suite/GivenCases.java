package org.sitaf.core.suite;

import java.util.List;
import java.util.Optional;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestValue;

/** Test cases with given values instead of combined ones. */
public final class GivenCases {
  private final TestModel model;
  private final Conditions conditions;
  private final Oracle oracle;

  /**
   * Compiles the conditions of a model.
   *
   * @throws InvalidInputException if a condition is invalid
   */
  public GivenCases(TestModel model) {
    Diagnostics diagnostics = new Diagnostics();
    this.model = model;
    this.conditions = Conditions.compile(model, diagnostics);
    diagnostics.throwIfErrors();
    this.oracle = new Oracle(model, conditions, new Diagnostics());
  }

  /**
   * A case of valid values with its expected values; empty if a pre-condition excludes it or cannot
   * be evaluated for it.
   *
   * @param values one for each input of the model
   */
  public Optional<TestCase> of(int no, List<Value> values) {
    return ofRow(no, values.stream().map(value -> new TestValue(value, true)).toList());
  }

  /**
   * A case with its expected values; empty if a pre-condition excludes it or cannot be evaluated
   * for it.
   *
   * @param row one value for each input of the model
   */
  public Optional<TestCase> ofRow(int no, List<TestValue> row) {
    return allows(row) ? Optional.of(unchecked(no, row)) : Optional.empty();
  }

  /** Whether the pre-conditions allow a case. */
  public boolean allows(List<TestValue> row) {
    Variables variables = CaseVariables.of(model, row);
    for (Expression condition : conditions.pre()) {
      try {
        if (!condition.isTrue(variables.map())) {
          return false;
        }
      } catch (EvaluationException e) {
        return false;
      }
    }
    return true;
  }

  private TestCase unchecked(int no, List<TestValue> row) {
    return new TestCase(
        no,
        row.stream().allMatch(TestValue::valid),
        row.stream().map(v -> v.value().literal()).toList(),
        oracle.expect(no, row));
  }
}
