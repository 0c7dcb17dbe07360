package org.sitaf.core.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The evaluation of any expression ends, within limits of steps and memory. */
@Tag("slow")
class ExpressionLimitsTest {
  private static final String DIGITS = "[0,1,2,3,4,5,6,7,8,9]";

  private final ExpressionCompiler compiler =
      new ExpressionCompiler(Set.of("x", "text", "items", Variables.CALLS));

  static List<String> tooLarge() {
    return List.of(
        nested("all", 14, "true"),
        nested("exists", 14, "false"),
        nested("exists_one", 14, "true"),
        nested("map", 9, "1") + " != []",
        nested("filter", 9, "true") + " != []",
        "[0,1]" + ".map(i, {i: i})".repeat(20) + " != []",
        "[0,1]" + ".map(i, {i: {i: i}})".repeat(20) + " != []",
        "(".repeat(9_000) + "1" + ")".repeat(9_000) + " == 1",
        "(".repeat(10_000) + "1" + ")".repeat(10_000) + " == 1",
        "x == 1 ? true : ".repeat(1_000) + "false",
        "x" + "[0]".repeat(2_000) + " == 1",
        "x" + ".a".repeat(2_000) + " == 1",
        "1" + " + 1".repeat(2_000) + " == 1",
        "[".repeat(1_000) + "]".repeat(1_000) + " == []",
        "'" + "a".repeat(1_000_000) + "' == text",
        "\"" + "\\u00e9\\U0001F600".repeat(20_000) + "\" == text",
        "x in [" + "1,".repeat(30_000) + "1]");
  }

  @ParameterizedTest
  @MethodSource("tooLarge")
  void rejectsATooLargeExpressionBeforeItsEvaluation(String text) {
    assertThatThrownBy(() -> compiler.compile(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("is not a valid expression")
        .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(2_000));
  }

  @Test
  void reportsTheNumberOfStepsOfARejectedExpression() {
    assertThatThrownBy(() -> compiler.compile(nested("all", 14, "true")))
        .hasMessageContaining("steps")
        .hasMessageContaining("5,000,000")
        .hasMessageContaining("use fewer nested macros");
  }

  static List<String> tooExpensive() {
    String doubled = ".map(s, s + s)".repeat(40);
    return List.of(
        nestedOver("items", "all", 6, "true"),
        nestedOver("items", "exists", 6, "false"),
        nestedOver("items", "exists_one", 6, "true"),
        nestedOver("items", "map", 5, "1") + " != []",
        nestedOver("items", "filter", 6, "true") + " != []",
        // CEL absorbs errors in operands of && and ||, but the limits must still end the
        // evaluation.
        nestedOver("items", "all", 6, "true") + " || " + nestedOver("items", "all", 6, "true"),
        "['ab']" + doubled + "[0] == text",
        "[[1, 2]]" + doubled + "[0] == items",
        "[b'ab']" + doubled + "[0] == b''",
        "[1]" + ".map(s, [s, s])".repeat(30) + " == [1]".replace("[1]", "dyn(items)"),
        "dyn(items) in [1]" + ".map(s, [s, s])".repeat(30).replace("items", "x"),
        "[1]" + ".map(s, [s])".repeat(120) + " == dyn(items)",
        "items.map(i, items.map(j, text + text + text)) == items",
        "items.exists(i, (text + text).matches('(a|b)*(a|b)*(a|b)*c'))",
        "items.map(i, det(identity(300))) == items",
        "items.map(i, matmul(identity(200), identity(200))) == items",
        "items.map(i, identity(1000)) == items",
        nestedOver("items", "all", 3, "norm(items) >= 0.0"),
        nestedOver("items", "all", 3, "near(items, items, 0)"),
        "text.matches('(((a{1000}){1000}){1000})')",
        "text.matches('((a{1,900}){1,900}|b){2,900}')",
        "text.matches(" + "'(a|b)*' + ".repeat(200) + "'')");
  }

  @ParameterizedTest
  @MethodSource("tooExpensive")
  void endsATooExpensiveEvaluation(String text) {
    Expression expression = compiler.compile(text);
    assertThatThrownBy(() -> expression.evaluate(variables()))
        .isInstanceOfSatisfying(
            EvaluationException.class, e -> assertThat(e.tooCostly()).as(e.toString()).isTrue());
  }

  /** Each absorbed error is an exception, so the number of steps does not bound the time. */
  @Test
  void endsAnEvaluationOfManyAbsorbedErrorsByItsTime() {
    Expression expression = compiler.compile(nestedOver("items", "all", 6, "1 / 0 == 1 || true"));
    assertThatThrownBy(() -> expression.evaluate(variables()))
        .isInstanceOfSatisfying(EvaluationException.class, e -> assertThat(e.tooCostly()).isTrue())
        .hasMessageContaining("3 s of processor time");
  }

  static List<String> usual() {
    return List.of(
        "x > 1 && x <= 10.5 || text == ''",
        "text.matches('^[A-Za-z0-9 .,_-]{0,64}.*') || true",
        "text.matches('[0-9]{4}-[0-9]{2}-[0-9]{2}') == false",
        "items.all(i, items.exists(j, j == i))",
        "items.map(i, [i, i * 2]).size() == items.size()",
        "items.map(i, {'a': i})[3].a == 3",
        "!".repeat(2_000) + "true",
        "true" + " && true".repeat(1_500),
        "'\\U0001F600é\u202e' + text != text",
        "x in [" + "1,".repeat(4_000) + "5]",
        DIGITS + ".all(a, " + DIGITS + ".all(b, " + DIGITS + ".all(c, a + b + c >= 0)))");
  }

  @ParameterizedTest
  @MethodSource("usual")
  void evaluatesCommonExpressions(String text) throws EvaluationException {
    assertThat(compiler.compile(text).isTrue(variables())).isTrue();
  }

  @Property(tries = 40)
  void rejectsOrEvaluatesAnyNesting(
      @ForAll @IntRange(min = 0, max = 12) int depth,
      @ForAll @IntRange(min = 0, max = 30) int length,
      @ForAll @IntRange(min = 0, max = 4) int macro) {
    String name = List.of("all", "exists", "exists_one", "map", "filter").get(macro);
    String list =
        IntStream.range(0, length)
            .mapToObj(String::valueOf)
            .collect(Collectors.joining(",", "[", "]"));
    String text = nestedOver(list, name, depth, "true");
    try {
      compiler.compile(text).evaluate(variables());
    } catch (IllegalArgumentException e) {
      // An evaluation that takes long must have reached the limit of steps.
      assertThat(Math.pow(length, depth) * 20).isGreaterThan(5_000_000);
    } catch (EvaluationException e) {
      // The estimate before the evaluation is only close to the steps that are counted then.
      assertThat(e.tooCostly() && Math.pow(length, depth) < 1_000).isFalse();
    }
  }

  @Test
  void anInterruptEndsAnEvaluation() throws InterruptedException {
    Expression expression = compiler.compile(nestedOver("items", "all", 3, "text != 'b'"));
    CountDownLatch begun = new CountDownLatch(1);
    AtomicReference<Throwable> end = new AtomicReference<>();
    Thread evaluating =
        new Thread(
            () -> {
              begun.countDown();
              try {
                while (true) {
                  expression.evaluate(Map.of("items", List.of(1L, 2L, 3L), "text", "a"));
                }
              } catch (CancellationException | EvaluationException e) {
                end.set(e);
              }
            });
    evaluating.start();
    begun.await();
    evaluating.interrupt();
    evaluating.join();
    assertThat(end.get()).isInstanceOf(CancellationException.class);
  }

  @Test
  void conjunctsAreTheTopLevelOperandsOfAnd() throws EvaluationException {
    List<Expression> parts =
        compiler.compile("x == 1 && (text == 'a' || x == 2) && (x < 9)").conjuncts();
    assertThat(parts).hasSize(3);
    assertThat(parts.get(0).mentions("text")).isFalse();
    assertThat(parts.get(1).mentions("text")).isTrue();
    assertThat(parts.get(2).isTrue(Map.of("x", 3L))).isTrue();
    assertThat(compiler.compile("x == 1 || text == 'a'").conjuncts()).hasSize(1);
  }

  @Property
  void expandsRepetitions(
      @ForAll @IntRange(min = 1, max = 40) int inner,
      @ForAll @IntRange(min = 1, max = 40) int outer) {
    assertThat(PatternSize.of("(a{" + inner + "}b){" + outer + "}"))
        .isBetween((long) inner * outer, (inner + 3L) * (outer + 1) + 3);
    assertThat(PatternSize.of("[{5}]a\\{9}\\p{L}[^]{9}]" + "x".repeat(inner)))
        .isLessThan(inner + 12L);
  }

  private static String nested(String macro, int depth, String inner) {
    return nestedOver(DIGITS, macro, depth, inner);
  }

  private static String nestedOver(String list, String macro, int depth, String inner) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < depth; i++) {
      text.append(list).append('.').append(macro).append("(i").append(i).append(", ");
      if (i < depth - 1 && macro.equals("filter")) {
        text.append("[] != ");
      }
    }
    return text.append(inner).append(")".repeat(depth)).toString();
  }

  private static Map<String, Object> variables() {
    Map<String, Object> variables = new HashMap<>();
    variables.put("x", 5L);
    variables.put("text", "ab".repeat(2_000));
    List<Object> items = new ArrayList<>();
    for (long i = 0; i < 100; i++) {
      items.add(i);
    }
    variables.put("items", items);
    variables.put(Variables.CALLS, Map.of());
    return variables;
  }
}
