package org.sitaf.core.expression;

import dev.cel.common.ast.CelConstant;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelCall;
import dev.cel.common.ast.CelExpr.CelComprehension;
import dev.cel.runtime.CelEvaluationException;
import dev.cel.runtime.CelFunctionOverload;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.expression.function.Library;

/**
 * Evaluates plain expressions of numbers and truth values without CEL's runtime, which takes about
 * a microsecond for each node.
 *
 * <p>It decides only where its result is certainly that of CEL: an operand of another type and
 * every error are left to CEL. It has no loops, so the size of an expression bounds its steps.
 */
final class DirectProgram {
  /** The values of variables; null for an unknown one. */
  interface Values {
    @Nullable Object get(String name);
  }

  /** The result of a node that only CEL can evaluate. */
  private static final Object UNDECIDED = new Object();

  private static final Set<String> EQUALITY = Set.of("@equals", "@not_equals");

  private static final Set<String> ORDER =
      Set.of("@less", "@less_equals", "@greater", "@greater_equals");

  private interface Node {
    Object value(Values values);
  }

  private final Node root;

  private DirectProgram(Node root) {
    this.root = root;
  }

  /** Compiles a linked expression; empty if it has a part that only CEL can evaluate. */
  static Optional<DirectProgram> compile(CelExpr linked) {
    return Optional.ofNullable(node(linked)).map(DirectProgram::new);
  }

  /** The value; empty if only CEL can find it. */
  Optional<Object> evaluate(Values values) {
    Object value = root.value(values);
    return isPlain(value) ? Optional.of(value) : Optional.empty();
  }

  private static boolean isPlain(Object value) {
    return value instanceof Double
        || value instanceof Long
        || value instanceof Boolean
        || value instanceof String;
  }

  private static @Nullable Node node(CelExpr expression) {
    return switch (expression.getKind()) {
      case CONSTANT -> constant(expression.constant());
      case IDENT -> variable(expression.ident().name());
      case SELECT -> expression.select().testOnly() ? null : select(expression);
      case CALL -> call(expression.call());
      case COMPREHENSION -> binding(expression.comprehension());
      default -> null;
    };
  }

  private static @Nullable Node constant(CelConstant constant) {
    Object value =
        switch (constant.getKind()) {
          case INT64_VALUE -> constant.int64Value();
          case DOUBLE_VALUE -> constant.doubleValue();
          case BOOLEAN_VALUE -> constant.booleanValue();
          case STRING_VALUE -> constant.stringValue();
          default -> null;
        };
    return value == null ? null : values -> value;
  }

  private static Node variable(String name) {
    return values -> orUndecided(values.get(name));
  }

  private static Object orUndecided(@Nullable Object value) {
    return value == null ? UNDECIDED : value;
  }

  private static @Nullable Node select(CelExpr expression) {
    Node operand = node(expression.select().operand());
    String field = expression.select().field();
    return operand == null
        ? null
        : values ->
            operand.value(values) instanceof Map<?, ?> map
                ? orUndecided(map.get(field))
                : UNDECIDED;
  }

  /** A definition, or {@code cel.bind}: a loop over nothing. */
  private static @Nullable Node binding(CelComprehension loop) {
    if (!loop.iterVar().equals("#unused")) {
      return null;
    }
    Node bound = node(loop.accuInit());
    Node result = node(loop.result());
    String name = loop.accuVar();
    if (bound == null || result == null) {
      return null;
    }
    return values -> {
      Object value = bound.value(values);
      return value == UNDECIDED
          ? UNDECIDED
          : result.value(other -> other.equals(name) ? value : values.get(other));
    };
  }

  private static @Nullable Node call(CelCall call) {
    if (call.target().isPresent()) {
      return null;
    }
    String function = call.function();
    if (function.equals("min") || function.equals("max")) {
      return extreme(function, call);
    }
    List<Node> arguments = nodes(call.args());
    if (arguments == null) {
      return null;
    }
    boolean equality = EQUALITY.contains(function);
    if (equality || ORDER.contains(function)) {
      return comparison(
          Library.ofScalars(function, 2).orElseThrow(), equality, arguments.toArray(Node[]::new));
    }
    return switch (function) {
      case "_&&_" -> junction(arguments.get(0), arguments.get(1), false);
      case "_||_" -> junction(arguments.get(0), arguments.get(1), true);
      case "!_" -> negation(arguments.get(0));
      case "_?_:_" -> choice(arguments.get(0), arguments.get(1), arguments.get(2));
      case "_[_]" -> element(arguments.get(0), arguments.get(1));
      default ->
          Library.ofScalars(function, arguments.size())
              .map(overload -> applied(overload, arguments))
              .orElse(null);
    };
  }

  private static @Nullable List<Node> nodes(List<CelExpr> expressions) {
    List<Node> nodes = new ArrayList<>();
    for (CelExpr expression : expressions) {
      Node node = node(expression);
      if (node == null) {
        return null;
      }
      nodes.add(node);
    }
    return nodes;
  }

  /** The least or greatest of numbers that are written as arguments, or in a variable. */
  private static @Nullable Node extreme(String function, CelCall call) {
    CelExpr list = call.args().get(0);
    List<Node> elements =
        list.getKind() == CelExpr.ExprKind.Kind.LIST ? nodes(list.list().elements()) : null;
    CelFunctionOverload overload = Library.ofNumbers(function);
    if (list.getKind() == CelExpr.ExprKind.Kind.IDENT) {
      String name = list.ident().name();
      return values ->
          values.get(name) instanceof List<?> given
                  && given.stream().allMatch(Double.class::isInstance)
              ? applied(overload, (Object) given)
              : UNDECIDED;
    }
    if (elements == null) {
      return null;
    }
    Node[] arguments = elements.toArray(Node[]::new);
    return values -> {
      Object[] given = numbers(arguments, values);
      return given == null ? UNDECIDED : applied(overload, (Object) List.of(given));
    };
  }

  private static Node applied(CelFunctionOverload function, List<Node> nodes) {
    Node[] arguments = nodes.toArray(Node[]::new);
    return values -> {
      Object[] given = numbers(arguments, values);
      return given == null ? UNDECIDED : applied(function, given);
    };
  }

  private static Object applied(CelFunctionOverload function, Object... given) {
    try {
      return orUndecided(function.apply(given));
    } catch (CelEvaluationException | RuntimeException e) {
      // CEL reports the error, or finds that it does not matter.
      return UNDECIDED;
    }
  }

  private static Object @Nullable [] numbers(Node[] nodes, Values values) {
    Object[] numbers = new Object[nodes.length];
    for (int i = 0; i < numbers.length; i++) {
      Object value = nodes[i].value(values);
      if (!(value instanceof Double || value instanceof Long)) {
        return null;
      }
      numbers[i] = value;
    }
    return numbers;
  }

  /**
   * @param decisive the value of one side that decides
   */
  private static Node junction(Node left, Node right, boolean decisive) {
    return values -> {
      Object first = left.value(values);
      if (!(first instanceof Boolean truth)) {
        return UNDECIDED;
      }
      if (truth == decisive) {
        return truth;
      }
      Object second = right.value(values);
      return second instanceof Boolean ? second : UNDECIDED;
    };
  }

  private static Node negation(Node operand) {
    return values -> operand.value(values) instanceof Boolean truth ? (Object) !truth : UNDECIDED;
  }

  private static Node choice(Node condition, Node first, Node second) {
    return values ->
        condition.value(values) instanceof Boolean truth
            ? (truth ? first : second).value(values)
            : UNDECIDED;
  }

  private static Node element(Node list, Node index) {
    return values ->
        list.value(values) instanceof List<?> elements
                && index.value(values) instanceof Long at
                && at >= 0
                && at < elements.size()
            ? orUndecided(elements.get(at.intValue()))
            : UNDECIDED;
  }

  /** Numbers in any comparison, and whether texts or truth values are equal. */
  private static Node comparison(CelFunctionOverload operator, boolean equality, Node[] operands) {
    return values -> {
      Object a = operands[0].value(values);
      Object b = operands[1].value(values);
      boolean numbers =
          (a instanceof Double || a instanceof Long) && (b instanceof Double || b instanceof Long);
      boolean same =
          a instanceof String && b instanceof String
              || a instanceof Boolean && b instanceof Boolean;
      return numbers || equality && same ? applied(operator, a, b) : UNDECIDED;
    };
  }
}
