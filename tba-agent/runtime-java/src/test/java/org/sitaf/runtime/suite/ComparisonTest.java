package org.sitaf.runtime.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ComparisonTest {
  private static final Tolerance EXACT = Tolerance.EXACT;

  private static Optional<String> difference(String expected, Object actual) {
    return Comparison.difference(expected, actual, EXACT).map(ComparisonTest::spelled);
  }

  private static String spelled(Comparison.Difference difference) {
    return (difference.way().isEmpty() ? "" : difference.way() + ": ") + difference.text();
  }

  @Test
  void everyDoubleEqualsItsOwnLiteralExactlyAndNoNeighbour() {
    Random random = new Random(1);
    for (int i = 0; i < 2000; i++) {
      double value = Double.longBitsToDouble(random.nextLong());
      assertThat(difference(Literals.of(value), value)).as("%s", value).isEmpty();
      if (Double.isFinite(value)) {
        assertThat(difference(Literals.of(value), Math.nextUp(value))).as("%s", value).isPresent();
      }
    }
  }

  @Test
  void everyFloatEqualsItsOwnLiteral() {
    Random random = new Random(2);
    for (int i = 0; i < 2000; i++) {
      float value = Float.intBitsToFloat(random.nextInt());
      assertThat(difference(Literals.of(value), value)).as("%s", value).isEmpty();
    }
  }

  @Test
  void aToleranceTakesWhatLiesWithinItAndNothingBeyond() {
    Random random = new Random(3);
    for (int i = 0; i < 2000; i++) {
      double expected = random.nextGaussian() * 100;
      Tolerance tolerance = new Tolerance(random.nextDouble(), random.nextDouble() / 10);
      double allowed = tolerance.absolute() + tolerance.relative() * Math.abs(expected);
      String literal = Double.toString(expected);
      assertThat(Comparison.difference(literal, expected + allowed * 0.999, tolerance)).isEmpty();
      assertThat(Comparison.difference(literal, expected - allowed * 0.999, tolerance)).isEmpty();
      assertThat(Comparison.difference(literal, expected + allowed * 1.001, tolerance)).isPresent();
      assertThat(Comparison.difference(literal, expected - allowed * 1.001, tolerance)).isPresent();
    }
  }

  @Test
  void numbersCompareAsNumbers() {
    assertThat(difference("-1", -1.0)).isEmpty();
    assertThat(difference("-1.0", -1)).isEmpty();
    assertThat(difference("1e3", 1000L)).isEmpty();
    assertThat(difference("0.0", -0.0)).isEmpty();
    assertThat(difference("0.1", 0.1f)).isEmpty();
    assertThat(difference("18446744073709551615", new BigInteger("18446744073709551615")))
        .isEmpty();
    assertThat(difference("9007199254740993", 9007199254740992L)).isPresent();
    assertThat(Comparison.difference("10", 12, new Tolerance(2, 0))).isEmpty();
    assertThat(Comparison.difference("10", 13, new Tolerance(2, 0))).isPresent();
  }

  @Test
  void notANumberEqualsItselfWhenItIsExpectedAndNothingElse() {
    assertThat(difference("NaN", Double.NaN)).isEmpty();
    assertThat(difference("NaN", 1.0)).isPresent();
    assertThat(Comparison.difference("1", Double.NaN, new Tolerance(1e300, 1))).isPresent();
  }

  @Test
  void noToleranceMakesAnInfinityOfAFiniteNumber() {
    Tolerance wide = new Tolerance(Double.MAX_VALUE, 1);
    assertThat(Comparison.difference("Infinity", 5.0, wide)).isPresent();
    assertThat(Comparison.difference("5", Double.POSITIVE_INFINITY, wide)).isPresent();
    assertThat(Comparison.difference("-Infinity", Double.POSITIVE_INFINITY, wide)).isPresent();
    assertThat(Comparison.difference("Infinity", 5, wide)).isPresent();
    assertThat(Comparison.difference("Infinity", Double.POSITIVE_INFINITY, wide)).isEmpty();
  }

  @Test
  void theMessageNamesTheFirstDifferenceOfASequence() {
    double[] actual = {1, 2, 4};
    assertThat(
            Comparison.difference("[1, 2.5, 3]", actual, new Tolerance(0.1, 0))
                .map(ComparisonTest::spelled))
        .contains("[1]: expected 2.5, but was 2.0 (differs by 0.5, allowed 0.1)");
    assertThat(difference("[1, 2]", List.of(1))).contains("expected 2 elements, but there are 1");
    assertThat(difference("[]", new int[0])).isEmpty();
    assertThat(difference("[1, 2]", new int[] {1, 2})).isEmpty();
  }

  /** As it is generated for a struct of an interface. */
  record Point(double x, double y) {
    Point() {
      this(0, 0);
    }
  }

  /** A struct within a struct, and a sequence of structs. */
  record Leg(Point from, Point[] via, String name) {}

  @Test
  void structsCompareByTheMembersThatAreExpectedAndNameTheWayToTheDifference() {
    Leg leg = new Leg(new Point(1, 2), new Point[] {new Point(), new Point(3, 4)}, "a, }b");
    assertThat(Literals.of(leg))
        .isEqualTo(
            "{from: {x: 1.0, y: 2.0}, via: [{x: 0.0, y: 0.0}, {x: 3.0, y: 4.0}], name: \"a, }b\"}");
    assertThat(difference(Literals.of(leg), leg)).isEmpty();
    assertThat(difference("{name: \"a, }b\", via: [{}, {y: 4}]}", leg)).isEmpty();
    assertThat(difference("{via: [{}, {y: 5}]}", leg))
        .contains("via[1].y: expected 5, but was 4.0".replaceFirst("^", "."));
    assertThatThrownBy(() -> difference("{z: 1}", leg))
        .isInstanceOf(CaseDataException.class)
        .hasMessageContaining("Leg has no member z");
  }

  @Test
  void unitsInTheLastPlaceAreThoseOfTheExpectedNumber() {
    Tolerance two = new Tolerance(0, 0, 2);
    Random random = new Random(4);
    for (int i = 0; i < 1000; i++) {
      double expected = random.nextGaussian() * Math.pow(10, random.nextInt(40) - 20);
      String literal = Double.toString(expected);
      double near = expected + 2 * Math.ulp(expected);
      assertThat(Comparison.difference(literal, near, two)).as(literal).isEmpty();
      assertThat(Comparison.difference(literal, expected + 3 * Math.ulp(expected), two))
          .isPresent();
      float single = (float) expected;
      String singleLiteral = Float.toString(single);
      assertThat(Comparison.difference(singleLiteral, single + 2 * Math.ulp(single), two))
          .isEmpty();
    }
    assertThat(Comparison.difference("5", 6, two)).isPresent();
  }

  @Test
  void sequencesOfAwkwardStringsEqualTheirOwnLiteral() {
    List<String> strings = List.of("", "a, b", "]", "\"quoted\"", "back\\slash", " blank ", "ü");
    assertThat(Literals.elements(Literals.of(strings))).isEqualTo(strings);
    assertThat(difference(Literals.of(strings), strings)).isEmpty();
  }

  @Test
  void stringsAndTruthsCompareWithoutTolerance() {
    assertThat(difference("abc", "abc")).isEmpty();
    assertThat(difference("abc", "abc ")).contains("expected 'abc', but was 'abc '");
    assertThat(difference("1", "1.0")).isPresent();
    assertThat(difference("true", true)).isEmpty();
    assertThat(difference("0", true)).contains("expected 0, but was true");
    assertThat(difference("x", 'x')).isEmpty();
    assertThat(difference("5", null)).contains("expected '5', but was 'null'".replace("'", ""));
  }

  @Test
  void anExpectationThatIsNoNumberIsNotAWrongValue() {
    assertThatThrownBy(() -> difference("five", 5.0))
        .isInstanceOf(CaseDataException.class)
        .hasMessageContaining("'five' is not a number");
  }
}
