package org.sitaf.core.expression;

import dev.cel.common.ast.CelExpr;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
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
    return text(condition.parsed(), false);
  }

  /**
   * @param negated whether the node is true where it should be false
   */
  private String text(CelExpr node, boolean negated) {
    String function = Expression.function(node);
    List<CelExpr> arguments = function.isEmpty() ? List.of() : new ArrayList<>(node.call().args());
    return switch (function) {
      case "_&&_", "_||_" -> {
        List<CelExpr> operands = new ArrayList<>();
        Expression.operands(function, node, operands);
        // Of a conjunction, the first false operand decides; of a disjunction, all do.
        List<String> texts =
            operands.stream()
                .filter(o -> is(o, negated))
                .map(o -> text(o, negated))
                .filter(t -> !t.isEmpty())
                .toList();
        yield function.equals("_&&_") != negated
            ? texts.stream().findFirst().orElse("")
            : String.join(" and ", texts);
      }
      case "!_" -> text(arguments.get(0), !negated);
      case "_?_:_" -> text(arguments.get(is(arguments.get(0), true) ? 1 : 2), negated);
      case "_<_", "_<=_", "_>_", "_>=_", "_==_", "_!=_", "@in" ->
          value(arguments.get(0))
              + " "
              + (function.equals("@in") ? "in" : function.replace("_", ""))
              + " "
              + value(arguments.get(1));
      case "", "_[_]", "dyn" -> "";
      default ->
          node.call().target().map(t -> value(t) + ".").orElse("")
              + function
              + arguments.stream().map(this::value).collect(Collectors.joining(", ", "(", ")"));
    };
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
