package org.sitaf.core.expression;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.common.primitives.UnsignedLong;
import java.util.List;
import java.util.Map;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** The direct evaluation gives what CEL gives: the same value or the same error. */
class DirectProgramTest {
  private static final List<String> VARIABLES =
      List.of("a", "b", "i", "j", "p", "s", "r.x", "l[1]");
  private static final ExpressionCompiler COMPILER =
      new ExpressionCompiler(List.of("a", "b", "i", "j", "p", "s", "r", "l"));

  private static Object result(Expression expression, Map<String, Object> values, boolean byCel) {
    try {
      return byCel ? expression.evaluateByCel(values) : expression.evaluate(values);
    } catch (EvaluationException e) {
      return "error: " + e.getMessage();
    }
  }

  @Property(tries = 3000)
  void agreesWithCel(
      @ForAll("expressions") String text,
      @ForAll("numbers") Object a,
      @ForAll("numbers") Object b,
      @ForAll("numbers") Object i,
      @ForAll boolean p) {
    Expression expression;
    try {
      expression = COMPILER.compile(text);
    } catch (IllegalArgumentException e) {
      return;
    }
    Map<String, Object> values =
        Map.of(
            "a",
            a,
            "b",
            b,
            "i",
            i,
            "j",
            3L,
            "p",
            p,
            "s",
            "text",
            "r",
            Map.of("x", b),
            "l",
            List.of(1.0, a));
    assertThat(result(expression, values, false))
        .as("%s with %s", text, values)
        .isEqualTo(result(expression, values, true));
  }

  @Provide
  Arbitrary<Object> numbers() {
    return Arbitraries.of(
        0.0,
        -0.0,
        1.0,
        -2.5,
        1e300,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.MIN_VALUE,
        0L,
        3L,
        -7L,
        Long.MAX_VALUE,
        Long.MIN_VALUE,
        UnsignedLong.MAX_VALUE);
  }

  @Provide
  Arbitrary<String> expressions() {
    return expression(4);
  }

  private static Arbitrary<String> expression(int depth) {
    Arbitrary<String> leaf =
        Arbitraries.of(VARIABLES)
            .map(String::toString)
            .edgeCases(none -> none.none())
            .flatMap(
                name ->
                    Arbitraries.of(
                        name, name, "1", "0.5", "-0.0", "nan", "true", "\"text\"", "pi"));
    if (depth == 0) {
      return leaf;
    }
    Arbitrary<String> inner = expression(depth - 1);
    Arbitrary<String> binary =
        Combinators.combine(
                inner,
                Arbitraries.of(
                    "+", "-", "*", "/", "%", "<", "<=", ">", ">=", "==", "!=", "&&", "||"),
                inner)
            .as((x, operator, y) -> "(" + x + " " + operator + " " + y + ")");
    Arbitrary<String> unary =
        Combinators.combine(
                Arbitraries.of("-", "!", "abs", "sqrt", "floor", "round", "sign", "is_nan", "sin"),
                inner)
            .as((function, x) -> function + "(" + x + ")");
    Arbitrary<String> more =
        Combinators.combine(
                Arbitraries.of(
                    "clamp(%s, %s, %s)",
                    "(%s ? %s : %s)",
                    "max(%s, %s, %s)",
                    "cel.bind(v, %s, v == %s || v < %s)",
                    "near(%s, %s, abs(%s))",
                    "(%s in [%s, %s])"),
                inner,
                inner,
                inner)
            .as((form, x, y, z) -> form.formatted(x, y, z));
    return Arbitraries.oneOf(leaf, binary, binary, unary, more);
  }

  @Example
  void evaluatesPlainConditionsDirectly() throws Exception {
    for (String text :
        List.of(
            "abs(a - b) <= 0.5 && i < j || !p",
            "max(a, b, 1.0) > 2.0 ? a * b : a / 2.0",
            "r.x + l[1] >= -1e9",
            "cel.bind(v, a * 2.0, v * v > b)",
            "s == \"text\"")) {
      Linker linker = new Linker(Scope.untyped(List.of("a", "b", "i", "j", "p", "s", "r", "l")));
      Map<String, Object> values =
          Map.of(
              "a",
              1.5,
              "b",
              2.5,
              "i",
              1L,
              "j",
              3L,
              "p",
              true,
              "s",
              "text",
              "r",
              Map.of("x", 1.0),
              "l",
              List.of(1.0, 2.0));
      DirectProgram program =
          DirectProgram.compile(linker.link(ExpressionCompiler.parse(text))).orElseThrow();
      assertThat(program.evaluate(values::get)).as(text).isPresent();
    }
  }
}
