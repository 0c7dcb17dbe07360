package org.sitaf.core.suite;

import dev.cel.common.values.NullValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;

/** Works out what each case expects, from the expressions of the model. */
final class Oracle {
  /**
   * Begins an expected value that could not be worked out: the driver makes an ERROR of such a
   * case.
   */
  private static final String UNEVALUATED = "!unevaluated:";

  /** What a call is expected to return that returns nothing. */
  private static final String NOTHING = "null";

  /** Further cases without a value are counted only. */
  private static final int MAX_WARNINGS = 1_000;

  /** Characters of a value in a message. */
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
  List<ExpectedValue> expect(int no, boolean valid, List<Value> values) {
    Variables variables = new Variables().put(Variables.VALID, valid);
    for (int i = 0; i < values.size(); i++) {
      variables.put(model.inputs().get(i).name(), values.get(i), model.inputs().get(i).type());
    }
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

  /** Says what was counted and not listed. */
  void tell() {
    if (unevaluated > MAX_WARNINGS) {
      diagnostics.warning(
          model.source(),
          0,
          "output_spec_list",
          "has no value in " + (unevaluated - MAX_WARNINGS) + " cases more");
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
        // It would take as much in each of the other cases.
        diagnostics.error(
            model.source(),
            output.line(),
            "test_element " + output.name() + "/expected",
            "in case " + no + " (" + inputs(values) + "): " + e.getMessage());
        diagnostics.throwIfErrors();
      }
      if (++unevaluated > MAX_WARNINGS) {
        return UNEVALUATED + " " + e.getMessage();
      }
      diagnostics.warning(
          model.source(),
          output.line(),
          "test_element " + output.name() + "/expected",
          "has no value in case " + no + " (" + inputs(values) + "): " + e.getMessage());
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
   * The literal of a result in the type of its output, so that {@code -1} for a double is {@code
   * -1.0}.
   */
  static String literal(Object result, DataType type) {
    if (result instanceof String text && text.startsWith(Value.MARK_OF_ERROR)) {
      return text;
    }
    if (type.equals(new DataType.Scalar(ScalarType.VOID))) {
      if (!(result instanceof NullValue)) {
        throw new IllegalArgumentException(
            "nothing is returned: only null or an error such as \"!error:NAME\" can be expected,"
                + " not "
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

  /** Texts within a list or a map are quoted, so that a comma in them separates nothing. */
  private static String nested(Object result, DataType type) {
    return result instanceof String text && !(type instanceof DataType.Enumeration)
        ? '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"'
        : literal(result, type);
  }
}
