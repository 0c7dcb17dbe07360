package org.sitaf.core.suite;

import dev.cel.common.values.NullValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.description.DataType;
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
  /**
   * Prefix of an expected value that could not be computed. The test driver reports such a case as
   * ERROR.
   */
  private static final String UNEVALUATED = "!unevaluated:";

  /** The expected value of a method that returns nothing. */
  private static final String NOTHING = "null";

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
      return literal(expression.evaluate(variables.map()), output.type());
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
        return UNEVALUATED + " " + e.getMessage();
      }
      diagnostics.warning(
          model.source(),
          output.expectedLine(),
          "test_element " + output.name() + "/expected",
          "cannot be evaluated in case " + no + " (" + inputs(values) + "): " + e.getMessage());
      return UNEVALUATED + " " + e.getMessage();
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

  /**
   * Converts a result to a literal of the output's type: {@code -1} for a double becomes {@code
   * -1.0}.
   */
  static String literal(Object result, DataType type) {
    if (result instanceof String text && Value.isOutcome(text)) {
      return text;
    }
    if (type.isVoid()) {
      if (!(result instanceof NullValue)) {
        throw new IllegalArgumentException(
            "the method returns nothing; expect null or an error such as \"!error:NAME\", not "
                + result);
      }
      return NOTHING;
    }
    if (result instanceof Map<?, ?> map) {
      return map.entrySet().stream()
          .map(
              e ->
                  e.getKey() + ": " + nested(e.getValue(), type.member(String.valueOf(e.getKey()))))
          .collect(Collectors.joining(", ", "{", "}"));
    }
    if (result instanceof List<?> list) {
      DataType element =
          type instanceof DataType.Sequence sequence
              ? sequence.element()
              : type instanceof DataType.FixedArray array ? array.element() : type;
      return list.stream().map(e -> nested(e, element)).collect(Collectors.joining(", ", "[", "]"));
    }
    return Value.parse(String.valueOf(result), type).literal();
  }

  /** Quotes strings in a list or a map, since they may contain commas. */
  private static String nested(Object result, DataType type) {
    return result instanceof String text && !(type instanceof DataType.Enumeration)
        ? '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"'
        : literal(result, type);
  }
}
