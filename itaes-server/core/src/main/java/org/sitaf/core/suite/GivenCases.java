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

/** Test cases with given, valid values instead of combined ones. */
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
   * A case with its expected values; empty if a pre-condition excludes it or cannot be evaluated
   * for it.
   *
   * @param values one for each input of the model
   */
  public Optional<TestCase> of(int no, List<Value> values) {
    List<TestValue> row = values.stream().map(value -> new TestValue(value, true)).toList();
    Variables variables = CaseVariables.of(model, row);
    for (Expression condition : conditions.pre()) {
      try {
        if (!condition.isTrue(variables.map())) {
          return Optional.empty();
        }
      } catch (EvaluationException e) {
        return Optional.empty();
      }
    }
    return Optional.of(
        new TestCase(
            no, true, values.stream().map(Value::literal).toList(), oracle.expect(no, row)));
  }
}
