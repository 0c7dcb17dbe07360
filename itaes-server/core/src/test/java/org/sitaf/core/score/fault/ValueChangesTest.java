package org.sitaf.core.score.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;

class ValueChangesTest {
  private static final DataType DOUBLE = new DataType.Scalar(ScalarType.DOUBLE);
  private static final DataType POINT =
      new DataType.Struct(
          "Point",
          List.of(
              new DataType.Member("x", DOUBLE),
              new DataType.Member("y", DOUBLE),
              new DataType.Member("name", new DataType.Scalar(ScalarType.STRING))));

  private static String changed(DataType type, String fault, String literal) {
    return ValueChanges.of(type).stream()
        .filter(c -> c.text().equals(fault))
        .findFirst()
        .orElseThrow()
        .apply(literal);
  }

  @ParameterizedTest
  @CsvSource({
    "DOUBLE, radians taken for degrees, 180.0, 3.141592653589793",
    "DOUBLE, metres taken for millimetres, 2.0, 0.002",
    "DOUBLE, sign inverted, 0.0, 0.0",
    "DOUBLE, sign inverted, -1.5, 1.5",
    "DOUBLE, one unit in the last place too large, 1.0, 1.0000000000000002",
    "DOUBLE, single precision, 0.1, 0.10000000149011612",
    "DOUBLE, NaN instead of the value, NaN, NaN",
    "DOUBLE, sign inverted, text, text",
    "FLOAT, one unit in the last place too large, 1.0, 1.0000001",
    "INT32, one too large, 2147483647, 2147483647",
    "INT32, sign inverted, 5, -5",
    "UINT8, one too small, 0, 0",
    "INT32, bytes of the lowest 16 bits swapped, 258, 513",
    "BOOLEAN, inverted, true, false",
    "STRING, last character lost, abc, ab",
  })
  void scalarsChange(ScalarType type, String fault, String literal, String expected) {
    assertThat(changed(new DataType.Scalar(type), fault, literal)).isEqualTo(expected);
  }

  /** The literals are those that a component recorded. */
  @ParameterizedTest
  @ValueSource(strings = {"1e999999999", "1e-999999999", "-1E+400000000"})
  @Timeout(20)
  void hugeNumbersStay(String literal) {
    DataType type = new DataType.Scalar(ScalarType.INT32);
    assertThat(changed(type, "sign inverted", literal)).isEqualTo(literal);
  }

  @Test
  void membersChange() {
    String literal = "{x: 1.0, y: -2.5, name: \"a, b\"}";
    assertThat(changed(POINT, "members x and y swapped", literal))
        .isEqualTo("{x: -2.5, y: 1.0, name: \"a, b\"}");
    assertThat(changed(POINT, "member y: sign inverted", literal))
        .isEqualTo("{x: 1.0, y: 2.5, name: \"a, b\"}");
    assertThat(changed(POINT, "member name: last character lost", literal))
        .isEqualTo("{x: 1.0, y: -2.5, name: \"a, \"}");
    assertThat(changed(POINT, "all numbers: sign inverted", literal))
        .isEqualTo("{x: -1.0, y: 2.5, name: \"a, b\"}");
  }

  @Test
  void elementsChange() {
    DataType sequence = new DataType.Sequence(DOUBLE, 0);
    assertThat(changed(sequence, "order reversed", "[1.0, 2.0, 3.0]")).isEqualTo("[3.0, 2.0, 1.0]");
    assertThat(changed(sequence, "last element lost", "[1.0]")).isEqualTo("[]");
    assertThat(changed(sequence, "last element lost", "[]")).isEqualTo("[]");
    assertThat(changed(sequence, "first element: always 0", "[1.0, 2.0]")).isEqualTo("[0.0, 2.0]");
  }

  @Test
  void hostileLiteralsStayAsTheyAre() {
    String deep = "[".repeat(10_000) + "]".repeat(10_000);
    for (ValueChange change : ValueChanges.of(new DataType.Sequence(DOUBLE, 0))) {
      assertThat(change.apply("{")).isEqualTo("{");
      assertThat(change.apply("[\"")).isNotNull();
      assertThat(change.apply(deep)).isNotNull();
    }
  }
}
