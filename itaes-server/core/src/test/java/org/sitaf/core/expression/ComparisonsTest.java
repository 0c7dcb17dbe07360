package org.sitaf.core.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.common.primitives.UnsignedLong;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Numbers compare by their values, whatever their types are. */
class ComparisonsTest {
  private static final ExpressionCompiler COMPILER =
      new ExpressionCompiler(
          List.of("nan", "minus_zero", "zero", "whole", "natural", "large", "odd", "list", "text"));

  private static final Map<String, Object> VALUES =
      Map.of(
          "nan",
          Double.NaN,
          "minus_zero",
          -0.0,
          "zero",
          0.0,
          "whole",
          0L,
          "natural",
          UnsignedLong.ZERO,
          "large",
          9007199254740992.0,
          "odd",
          9007199254740993L,
          "list",
          List.of(-0.0, 1L),
          "text",
          "b");

  private static Object value(String text, boolean byCel) throws EvaluationException {
    Expression expression = COMPILER.compile(text);
    return byCel ? expression.evaluateByCel(VALUES) : expression.evaluate(VALUES);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"0", "0.0", "0u", "whole", "natural", "zero", "minus_zero", "-1", "1", "nan"})
  void notANumberIsInNoOrder(String other) throws EvaluationException {
    for (boolean byCel : List.of(false, true)) {
      for (String operator : List.of("<", "<=", ">", ">=", "==")) {
        assertThat(value("nan " + operator + " " + other, byCel)).isEqualTo(false);
        assertThat(value(other + " " + operator + " nan", byCel)).isEqualTo(false);
      }
      assertThat(value("nan != " + other, byCel)).isEqualTo(true);
      assertThat(value("nan in [" + other + "]", byCel)).isEqualTo(false);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "0.0", "0u", "whole", "natural", "zero", "minus_zero"})
  void minusZeroIsZero(String other) throws EvaluationException {
    for (boolean byCel : List.of(false, true)) {
      for (String operator : List.of("<=", ">=", "==")) {
        assertThat(value("minus_zero " + operator + " " + other, byCel)).isEqualTo(true);
        assertThat(value(other + " " + operator + " minus_zero", byCel)).isEqualTo(true);
      }
      for (String operator : List.of("<", ">", "!=")) {
        assertThat(value("minus_zero " + operator + " " + other, byCel)).isEqualTo(false);
      }
      assertThat(value("minus_zero in [" + other + "]", byCel)).isEqualTo(true);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "large < odd | true",
        "large == odd | false",
        "odd > large | true",
        "odd <= large | false",
        "large == 9007199254740992 | true",
        "inf > odd | true",
        "-inf < odd | true",
        "1e300 > natural | true",
        "2.5 > 2 | true",
        "2 < 2.5 | true",
        "-2.5 < -2 | true",
        "3u > 2.5 | true",
        "list == [0, 1.0] | true",
        "list == [0, 1.0, 2] | false",
        "list != [0, 2] | true",
        "{'a': minus_zero} == {'a': 0} | true",
        "{'a': 1} == {'b': 1} | false",
        "{1: 'x'} == {1u: 'x'} | true",
        "1.0 in {1: 'x'} | true",
        "'a' in {'a': 1} | true",
        "text > 'a' | true",
        "text == 'b' | true",
        "text in ['a', 'b'] | true",
        "false < true | true",
        "b'a' < b'b' | true",
        "[1, [2.0]] == [1, [2]] | true",
        "list.exists_one(x, x == 0) | true",
        "list.all(x, x >= 0) | true",
      })
  void comparesByValue(String text, boolean expected) throws EvaluationException {
    assertThat(value(text, false)).isEqualTo(expected);
    assertThat(value(text, true)).isEqualTo(expected);
  }

  @Test
  void valuesOfOtherKindsAreInNoOrder() {
    assertThatThrownBy(() -> value("text < list", false))
        .isInstanceOf(EvaluationException.class)
        .hasMessageContaining("< does not apply to \"b\" and [-0.0, 1]");
  }
}
