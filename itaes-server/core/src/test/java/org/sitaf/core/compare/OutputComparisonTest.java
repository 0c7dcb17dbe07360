package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.compare.OutputComparison.Closeness;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;

class OutputComparisonTest {
  private static final DataType DOUBLE = new DataType.Scalar(ScalarType.DOUBLE);
  private static final DataType FLOAT = new DataType.Scalar(ScalarType.FLOAT);
  private static final DataType UNKNOWN = new DataType.Unknown("");

  private static Closeness of(DataType type, int ulp, String base, String now) {
    return new OutputComparison(type, ulp).compare(base, now).closeness();
  }

  @Property
  void numbersWithinTheUnitsDifferInTheLastBits(
      @ForAll double number, @ForAll @IntRange(min = 1, max = 9) int steps) {
    double start = Double.isFinite(number) ? number : 1;
    double moved = start;
    for (int i = 0; i < steps; i++) {
      moved = Math.nextAfter(moved, 0);
    }
    if (moved == start || Math.ulp(moved) != Math.ulp(start)) {
      return;
    }
    Closeness expected = steps <= 4 ? Closeness.LAST_BITS : Closeness.DIFFERENT;
    assertThat(of(DOUBLE, 4, Double.toString(start), Double.toString(moved))).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "NaN, nan, SAME",
    "Infinity, inf, SAME",
    "Infinity, -Infinity, DIFFERENT",
    "1.0, NaN, DIFFERENT",
    "0.0, -0.0, LAST_BITS",
    "1.0E7, 10000000, SAME",
    "1.0, 1.0000001, DIFFERENT",
    "null, 1.0, DIFFERENT"
  })
  void comparesSpecialNumbers(String base, String now, Closeness expected) {
    assertThat(of(DOUBLE, 4, base, now)).isEqualTo(expected);
    assertThat(of(DOUBLE, 4, now, base)).isEqualTo(expected);
  }

  @Test
  void theSignOfAZeroNeverCounts() {
    assertThat(of(DOUBLE, 0, "0.0", "-0.0")).isEqualTo(Closeness.LAST_BITS);
    assertThat(of(DOUBLE, 0, "1.0", "1.0000000000000002")).isEqualTo(Closeness.DIFFERENT);
  }

  @Test
  void floatsHaveTheirOwnPrecision() {
    assertThat(of(FLOAT, 4, "1.0", "1.0000001")).isEqualTo(Closeness.LAST_BITS);
    assertThat(of(FLOAT, 0, "1.0", "1.00000000001")).isEqualTo(Closeness.SAME);
    assertThat(of(FLOAT, 4, "1.0", "1.00001")).isEqualTo(Closeness.DIFFERENT);
    assertThat(of(FLOAT, 4, "3.4028235E38", "Infinity")).isEqualTo(Closeness.DIFFERENT);
  }

  @Test
  void theLargestMagnitudeOfTheOutputCounts() {
    DataType sequence = new DataType.Sequence(DOUBLE, 0);
    assertThat(of(sequence, 4, "[1000.0, 0.0]", "[1000.0, 1.0E-13]"))
        .isEqualTo(Closeness.LAST_BITS);
    assertThat(of(sequence, 4, "[1.0, 0.0]", "[1.0, 1.0E-13]")).isEqualTo(Closeness.DIFFERENT);
    assertThat(of(sequence, 4, "[Infinity, 0.0]", "[Infinity, 1.0E-13]"))
        .isEqualTo(Closeness.DIFFERENT);
    assertThat(of(sequence, 4, "[1.0]", "[1.0, 2.0]")).isEqualTo(Closeness.DIFFERENT);
  }

  @Test
  void wholeNumbersAreExact() {
    DataType whole = new DataType.Scalar(ScalarType.INT64);
    assertThat(of(whole, 4, "9007199254740993", "9007199254740992")).isEqualTo(Closeness.DIFFERENT);
    assertThat(of(UNKNOWN, 4, "3", "4")).isEqualTo(Closeness.DIFFERENT);
    assertThat(of(UNKNOWN, 4, "3", "3.0")).isEqualTo(Closeness.SAME);
    DataType struct =
        new DataType.Struct(
            "Reading", List.of(new DataType.Member("id", whole), new DataType.Member("x", DOUBLE)));
    assertThat(of(struct, 4, "{id: 1000000, x: 0.0}", "{id: 1000000, x: 1.0E-13}"))
        .as("the magnitude of a whole number does not hide a difference")
        .isEqualTo(Closeness.DIFFERENT);
  }

  @Test
  void stringsAndStructsCompareAsSuch() {
    DataType text = new DataType.Scalar(ScalarType.STRING);
    assertThat(of(text, 4, "1.0", "1.00")).isEqualTo(Closeness.DIFFERENT);
    assertThat(of(text, 4, "[a]", "[b]")).isEqualTo(Closeness.DIFFERENT);
    assertThat(of(UNKNOWN, 4, "{x: 1.0, y: \"a, b\"}", "{x: 1.0000000000000002, y: \"a, b\"}"))
        .isEqualTo(Closeness.LAST_BITS);
    assertThat(of(UNKNOWN, 4, "{x: 1.0}", "{y: 1.0}")).isEqualTo(Closeness.DIFFERENT);
    assertThat(of(UNKNOWN, 4, "[\"a", "[\"b")).isEqualTo(Closeness.DIFFERENT);
  }

  @Test
  void theDeviationIsTheLargestDifference() {
    OutputComparison comparison = new OutputComparison(UNKNOWN, 4);
    assertThat(comparison.compare("[1.0, 2.0]", "[1.25, 4.0]").deviation()).isEqualTo(2);
    assertThat(comparison.compare("[1.0, \"a\"]", "[1.25, \"b\"]").deviation()).isNaN();
  }

  @Test
  void deeplyNestedLiteralsEnd() {
    String nested = "[".repeat(2000) + "1" + "]".repeat(2000);
    assertThat(of(UNKNOWN, 4, nested, nested.replace('1', '2'))).isEqualTo(Closeness.DIFFERENT);
  }
}
