package org.sitaf.core.expression;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.common.primitives.UnsignedLong;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** The sign of a zero does not matter in comparisons, whatever the types of the numbers are. */
class SignOfZeroTest {
  private static final ExpressionCompiler COMPILER = new ExpressionCompiler(List.of("a", "b"));

  /** Comparisons that are true for equal numbers. */
  private static final List<String> TRUE =
      List.of(
          "a == b",
          "a <= b",
          "a >= b",
          "a in [b]",
          "a in [7, b]",
          "[a] == [b]",
          "[[1, a]] == [[1, b]]",
          "{'x': a} == {'x': b}",
          "max(a, b) == a",
          "min(a, b) >= b",
          "clamp(a, b, b) == b",
          "[a].exists(v, v == b)",
          "cel.bind(v, a, v >= b)",
          "is_sorted([a, b])",
          "(a == b) == true");

  private static final List<String> FALSE =
      List.of("a != b", "a < b", "a > b", "[a] != [b]", "!(a in [b])");

  @Provide
  Arbitrary<Object> zeros() {
    return Arbitraries.of(0.0, -0.0, 0L, UnsignedLong.ZERO);
  }

  @Property
  void allZerosAreEqual(@ForAll("zeros") Object a, @ForAll("zeros") Object b) throws Exception {
    Map<String, Object> values = Map.of("a", a, "b", b);
    for (String text : TRUE) {
      assertThat(both(text, values)).as("%s with %s", text, values).containsExactly(true);
    }
    for (String text : FALSE) {
      assertThat(both(text, values)).as("%s with %s", text, values).containsExactly(false);
    }
  }

  @Example
  void literalsAreZerosToo() throws Exception {
    Map<String, Object> values = Map.of("a", -0.0, "b", 2L);
    for (String text :
        List.of("a >= 0", "0 <= a", "a == 0", "0u == a", "!(a < 0)", "a in [0]", "0 in [a, 1]")) {
      assertThat(both(text, values)).as(text).containsExactly(true);
    }
    assertThat(both("-0.0 < 0 || a != 0 || [a, 1.0] != [0, 1]", values)).containsExactly(false);
  }

  @Example
  void valuesKeepTheSign() throws Exception {
    assertThat(COMPILER.compile("a").evaluate(Map.of("a", -0.0))).isEqualTo(-0.0);
    assertThat(COMPILER.compile("a <= b ? 1 / a : 0.0").evaluate(Map.of("a", -0.0, "b", 0L)))
        .isEqualTo(Double.NEGATIVE_INFINITY);
  }

  private static Set<Object> both(String text, Map<String, Object> values) throws Exception {
    Expression expression = COMPILER.compile(text);
    return new HashSet<>(List.of(expression.evaluate(values), expression.evaluateByCel(values)));
  }
}
