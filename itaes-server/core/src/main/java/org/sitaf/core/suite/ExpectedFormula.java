package org.sitaf.core.suite;

import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;

/** A CEL expression that computes the expected value of an output for each case. */
public final class ExpectedFormula {
  private final TestModel model;
  private final OutputElement output;
  private final Expression expression;

  private final InputValidity validity;

  private ExpectedFormula(TestModel model, OutputElement output, Expression expression, long seed) {
    this.validity = new InputValidity(model, seed);
    this.model = model;
    this.output = output;
    this.expression = expression;
  }

  /**
   * Compiles an expression over the inputs of a model and their validity.
   *
   * @param outputName name of the output; empty selects the only output
   * @param seed seed of the suite
   * @throws IllegalArgumentException if the model has no such output or the expression is invalid
   */
  public static ExpectedFormula compile(
      TestModel model, String outputName, String text, long seed) {
    OutputElement output =
        model
            .output(outputName)
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "the model has no output '"
                            + outputName
                            + "'; it has "
                            + model.outputs().stream().map(OutputElement::name).toList()));
    Expression expression =
        new ExpressionCompiler(CaseScope.beforeCall(model)).compile(ExpectedText.expression(text));
    ExpectedText.problem(expression, output.type())
        .ifPresent(
            problem -> {
              throw new IllegalArgumentException(problem);
            });
    return new ExpectedFormula(model, output, expression, seed);
  }

  /**
   * Computes the expected value of a case.
   *
   * @throws EvaluationException if the evaluation fails
   * @throws IllegalArgumentException if the result is not a value of the output's type
   */
  public ExpectedValue expect(TestCase testCase) throws EvaluationException {
    Variables variables = new Variables();
    validity.put(variables, testCase);
    for (int i = 0; i < testCase.values().size(); i++) {
      InputElement input = model.inputs().get(i);
      variables.put(input.name(), testCase.values().get(i), input.type());
    }
    String literal = ResultLiteral.of(expression.evaluate(variables.map()), output.type());
    return new ExpectedValue(model.outputs().size() == 1 ? "" : output.name(), literal);
  }
}
