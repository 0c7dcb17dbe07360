package org.sitaf.core.expression;

import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelComprehension;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/** Shows the values that decide why a condition is false: {@code 1.31 <= 1.2}. */
final class Explanation {
  /** Maximum length of a shown value. */
  private static final int MAX_VALUE = 100;

  private final Expression condition;
  private final Map<String, Object> values;

  Explanation(Expression condition, Map<String, Object> values) {
    this.condition = condition;
    this.values = values;
  }

  String text() {
    return text(condition.parsed(), false, UnaryOperator.identity());
  }

  /**
   * @param negated whether the node is true where it should be false
   * @param within gives a part its place in macros around it, whose variables it may use
   */
  private String text(CelExpr node, boolean negated, UnaryOperator<CelExpr> within) {
    String function = Expression.function(node);
    List<CelExpr> arguments = function.isEmpty() ? List.of() : new ArrayList<>(node.call().args());
    return switch (function) {
      case "_&&_", "_||_" -> {
        List<CelExpr> operands = new ArrayList<>();
        Expression.operands(function, node, operands);
        // Of a conjunction, the first false operand decides; of a disjunction, all do.
        List<String> texts =
            operands.stream()
                .filter(o -> is(within.apply(o), negated))
                .map(o -> text(o, negated, within))
                .filter(t -> !t.isEmpty())
                .toList();
        yield function.equals("_&&_") != negated
            ? texts.stream().findFirst().orElse("")
            : String.join(" and ", texts);
      }
      case "!_" -> text(arguments.get(0), !negated, within);
      case "_?_:_" ->
          text(arguments.get(is(within.apply(arguments.get(0)), true) ? 1 : 2), negated, within);
      case "_<_", "_<=_", "_>_", "_>=_", "_==_", "_!=_", "@in" ->
          value(within.apply(arguments.get(0)))
              + " "
              + (function.equals("@in") ? "in" : function.replace("_", ""))
              + " "
              + value(within.apply(arguments.get(1)));
      case "_[_]", "dyn" -> "";
      case "" ->
          node.getKind() == CelExpr.ExprKind.Kind.COMPREHENSION
              ? macro(node.comprehension(), negated, within)
              : "";
      default ->
          node.call().target().map(t -> value(within.apply(t)) + ".").orElse("")
              + function
              + arguments.stream()
                  .map(a -> value(within.apply(a)))
                  .collect(Collectors.joining(", ", "(", ")"));
    };
  }

  /** Of {@code all} and {@code exists}, the first element that decides. */
  private String macro(CelComprehension loop, boolean negated, UnaryOperator<CelExpr> within) {
    if (loop.iterVar().equals(Macros.UNUSED)) {
      UnaryOperator<CelExpr> bound =
          part -> within.apply(Macros.bind(loop.accuVar(), loop.accuInit(), part));
      return text(loop.result(), negated, bound);
    }
    String operator = Expression.function(loop.loopStep());
    if (!operator.equals(negated ? "_||_" : "_&&_") || !loop.iterVar2().isEmpty()) {
      return "";
    }
    CelExpr body = loop.loopStep().call().args().get(1);
    CelExpr first = Macros.first(loop, body, negated);
    UnaryOperator<CelExpr> bound = part -> within.apply(Macros.bind(loop.iterVar(), first, part));
    String why = text(body, negated, bound);
    return (why.isEmpty() ? "" : why + " ")
        + "for "
        + loop.iterVar()
        + " = "
        + value(within.apply(first));
  }

  private boolean is(CelExpr node, boolean wanted) {
    try {
      return condition.part(node).evaluate(values).equals(wanted);
    } catch (EvaluationException e) {
      return false;
    }
  }

  private String value(CelExpr node) {
    try {
      return shown(condition.part(node).evaluate(values));
    } catch (EvaluationException e) {
      return "(" + e.getMessage() + ")";
    }
  }

  private static String shown(Object value) {
    return Expression.shown(literal(value), MAX_VALUE);
  }

  private static String literal(Object value) {
    if (value instanceof String text) {
      return '"' + text + '"';
    }
    if (value instanceof List<?> list) {
      return list.stream()
          .limit(MAX_VALUE)
          .map(Explanation::shown)
          .collect(Collectors.joining(", ", "[", "]"));
    }
    if (value instanceof Map<?, ?> map) {
      return map.entrySet().stream()
          .limit(MAX_VALUE)
          .map(e -> e.getKey() + ": " + shown(e.getValue()))
          .collect(Collectors.joining(", ", "{", "}"));
    }
    return String.valueOf(value);
  }
}
