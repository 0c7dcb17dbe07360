package org.sitaf.core.expression;

import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelCall;
import dev.cel.common.ast.CelExpr.CelComprehension;
import dev.cel.common.ast.CelExpr.CelMap;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Estimates the maximum number of steps of an expression before it is compiled. A list in a
 * variable counts as one element; {@link StepMeter} counts the actual steps at runtime.
 */
final class StepEstimate {
  private final Map<String, Shape> scope = new HashMap<>();
  private double steps;
  private double repetitions = 1;
  private long largestType;

  private StepEstimate() {}

  /**
   * Checks a parsed expression.
   *
   * @throws IllegalArgumentException if it would exceed a limit
   */
  static void check(CelExpr expression) {
    StepEstimate estimate = new StepEstimate();
    estimate.shape(expression);
    if (estimate.steps > ExpressionLimits.MAX_STEPS) {
      throw new IllegalArgumentException(
          String.format(
              java.util.Locale.ROOT,
              "it takes up to %s steps, more than the limit of %,d; use fewer nested macros,"
                  + " such as all(), or shorter lists",
              estimate.steps < 1e15
                  ? String.format(java.util.Locale.ROOT, "%,.0f", estimate.steps)
                  : String.format(java.util.Locale.ROOT, "%.1e", estimate.steps),
              ExpressionLimits.MAX_STEPS));
    }
    if (estimate.largestType > ExpressionLimits.MAX_TYPE_PARTS) {
      throw new IllegalArgumentException(
          String.format(
              java.util.Locale.ROOT,
              "the type of a value in it has %s parts, more than the limit of %,d; use fewer"
                  + " nested lists and maps",
              estimate.largestType == Long.MAX_VALUE
                  ? "countless"
                  : String.format(java.util.Locale.ROOT, "%,d", estimate.largestType),
              ExpressionLimits.MAX_TYPE_PARTS));
    }
  }

  /**
   * The statically known properties of a value.
   *
   * @param length number of elements of a list or entries of a map; 1 if unknown
   * @param parts number of parts of the type
   * @param key shape of a loop variable over this value; null for a scalar
   * @param value shape of an indexed element; null for a scalar
   */
  private record Shape(double length, long parts, @Nullable Shape key, @Nullable Shape value) {
    static final Shape SCALAR = new Shape(1, 1, null, null);

    static Shape list(double length, Shape element) {
      return new Shape(length, plus(element.parts, 1), element, element);
    }

    static Shape map(double length, Shape key, Shape value) {
      return new Shape(length, plus(plus(key.parts, value.parts), 1), key, value);
    }

    Shape joined(Shape other) {
      Shape larger = parts >= other.parts ? this : other;
      return new Shape(Math.max(length, other.length), larger.parts, larger.key, larger.value);
    }

    Shape ofKey() {
      return key == null ? SCALAR : key;
    }

    Shape ofValue() {
      return value == null ? SCALAR : value;
    }

    private static long plus(long a, long b) {
      long sum = a + b;
      return sum < 0 ? Long.MAX_VALUE : sum;
    }
  }

  private Shape shape(CelExpr expression) {
    steps += repetitions;
    Shape shape =
        switch (expression.getKind()) {
          case IDENT -> scope.getOrDefault(expression.ident().name(), Shape.SCALAR);
          case SELECT -> shape(expression.select().operand()).ofValue();
          case CALL -> call(expression.call());
          case LIST -> list(expression);
          case MAP -> map(expression.map());
          case STRUCT -> {
            expression.struct().entries().forEach(e -> shape(e.value()));
            yield Shape.SCALAR;
          }
          case COMPREHENSION -> loop(expression.comprehension());
          default -> Shape.SCALAR;
        };
    largestType = Math.max(largestType, shape.parts());
    return shape;
  }

  private Shape list(CelExpr expression) {
    Shape element = Shape.SCALAR;
    for (CelExpr each : expression.list().elements()) {
      element = element.joined(shape(each));
    }
    return Shape.list(expression.list().elements().size(), element);
  }

  private Shape map(CelMap map) {
    Shape key = Shape.SCALAR;
    Shape value = Shape.SCALAR;
    for (CelMap.Entry entry : map.entries()) {
      key = key.joined(shape(entry.key()));
      value = value.joined(shape(entry.value()));
    }
    return Shape.map(map.entries().size(), key, value);
  }

  private Shape call(CelCall call) {
    call.target().ifPresent(this::shape);
    Shape[] arguments = call.args().stream().map(this::shape).toArray(Shape[]::new);
    return switch (call.function()) {
      case "_?_:_" -> arguments[1].joined(arguments[2]);
      case "_[_]" -> arguments[0].ofValue();
      case "dyn" -> arguments.length == 1 ? arguments[0] : Shape.SCALAR;
      case "_+_" -> {
        Shape joined = arguments[0].joined(arguments[1]);
        yield joined.value() == null
            ? joined
            : Shape.list(arguments[0].length() + arguments[1].length(), joined.ofValue());
      }
      default -> Shape.SCALAR;
    };
  }

  private Shape loop(CelComprehension loop) {
    Shape range = shape(loop.iterRange());
    Shape start = shape(loop.accuInit());
    Shape outerIter = scope.put(loop.iterVar(), range.ofKey());
    Shape outerSecond =
        loop.iterVar2().isEmpty() ? null : scope.put(loop.iterVar2(), range.ofValue());
    Shape outerAccumulated = scope.put(loop.accuVar(), start);
    double outside = repetitions;
    repetitions *= Math.max(1, range.length());
    shape(loop.loopCondition());
    Shape step = shape(loop.loopStep());
    repetitions = outside;
    // map() and filter() add the same number of elements in each iteration.
    double added = Math.max(0, step.length() - start.length()) * range.length();
    Shape accumulated =
        step.value() == null ? step : Shape.list(start.length() + added, step.ofValue());
    scope.put(loop.accuVar(), accumulated);
    Shape result = shape(loop.result());
    restore(loop.iterVar(), outerIter);
    if (!loop.iterVar2().isEmpty()) {
      restore(loop.iterVar2(), outerSecond);
    }
    restore(loop.accuVar(), outerAccumulated);
    return result;
  }

  private void restore(String name, @Nullable Shape outer) {
    if (outer == null) {
      scope.remove(name);
    } else {
      scope.put(name, outer);
    }
  }
}
