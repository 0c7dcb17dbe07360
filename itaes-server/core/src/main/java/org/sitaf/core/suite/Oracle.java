package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestValue;

/** Computes the expected values of test cases from the expressions of the model. */
final class Oracle {
  /** Maximum number of listed cases without an expected value; more are only counted. */
  private static final int MAX_WARNINGS = 1_000;

  /** Maximum length of a value in a message. */
  private static final int MAX_SHOWN = 200;

  private final TestModel model;
  private final Conditions conditions;
  private final Diagnostics diagnostics;
  private int unevaluated;

  Oracle(TestModel model, Conditions conditions, Diagnostics diagnostics) {
    this.model = model;
    this.conditions = conditions;
    this.diagnostics = diagnostics;
  }

  /** The expected values of a case, in the order of the model's outputs. */
  List<ExpectedValue> expect(int no, List<TestValue> row) {
    List<Value> values = row.stream().map(TestValue::value).toList();
    Variables variables = CaseVariables.of(model, row);
    List<ExpectedValue> expected = new ArrayList<>();
    for (OutputElement output : model.outputs()) {
      Expression expression = conditions.expected().get(output.name());
      if (expression != null) {
        String name = model.outputs().size() == 1 ? "" : output.name();
        expected.add(new ExpectedValue(name, literal(expression, variables, output, no, values)));
      }
    }
    return expected;
  }

  /** Reports the number of cases that were not listed. */
  void report() {
    if (unevaluated > MAX_WARNINGS) {
      diagnostics.warning(
          model.source(),
          0,
          "output_spec_list",
          "cannot be evaluated in " + (unevaluated - MAX_WARNINGS) + " more cases");
    }
  }

  private String literal(
      Expression expression,
      Variables variables,
      OutputElement output,
      int no,
      List<Value> values) {
    try {
      return ResultLiteral.of(expression.evaluate(variables.map()), output.type());
    } catch (EvaluationException | IllegalArgumentException e) {
      if (e instanceof EvaluationException evaluation && evaluation.tooCostly()) {
        // The other cases would most likely exceed the limit, too.
        diagnostics.error(
            model.source(),
            output.expectedLine(),
            "test_element " + output.name() + "/expected",
            "in case " + no + " (" + inputs(values) + "): " + e.getMessage());
        diagnostics.throwIfErrors();
      }
      if (++unevaluated > MAX_WARNINGS) {
        return ExpectedValue.UNEVALUATED + " " + e.getMessage();
      }
      diagnostics.warning(
          model.source(),
          output.expectedLine(),
          "test_element " + output.name() + "/expected",
          "cannot be evaluated in case " + no + " (" + inputs(values) + "): " + e.getMessage());
      return ExpectedValue.UNEVALUATED + " " + e.getMessage();
    }
  }

  private static String shown(String literal) {
    return literal.length() <= MAX_SHOWN ? literal : literal.substring(0, MAX_SHOWN) + "…";
  }

  private String inputs(List<Value> values) {
    return IntStream.range(0, values.size())
        .mapToObj(i -> model.inputs().get(i).name() + "=" + shown(values.get(i).literal()))
        .collect(Collectors.joining(", "));
  }
}
