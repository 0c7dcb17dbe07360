package org.sitaf.core.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.core.model.EquivalenceClass.TwoBoundary;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

class TestDataGeneratorTest {
  private static InputElement element(String realType, TestSpec spec, String... userValues) {
    var type = TypeGrammar.parse(realType).type();
    return new InputElement(
        "X",
        InputKind.TDI,
        realType,
        type,
        "",
        spec == null ? List.of() : List.of(spec),
        List.of(userValues).stream().map(v -> Value.parse(v, type)).toList(),
        0);
  }

  private static TwoBoundary between(String min, String max) {
    return new TwoBoundary(new BigDecimal(min), new BigDecimal(max), true, true);
  }

  private static TestSpec bva(EquivalenceClass declared, String offset) {
    return new TestSpec.BoundaryValues(declared, new BigDecimal(offset), TestSpec.Special.NONE);
  }

  private static TestSpec ecp(EquivalenceClass declared) {
    return new TestSpec.EquivalencePartitioning(declared, 1, BigDecimal.ONE, TestSpec.Special.NONE);
  }

  /** Values in their order; invalid ones are marked with an asterisk. */
  private static String values(InputElement element) {
    return TestDataGenerator.generate(element, 1).values().stream()
        .map(v -> v.value().literal() + (v.valid() ? "" : "*"))
        .collect(Collectors.joining(" "));
  }

  @Test
  void boundaryValuesOfTwoBoundariesAreThoseOfFigure6() {
    assertThat(values(element("int", bva(between("1", "7"), "1")))).isEqualTo("0* 1 2 4 6 7 8*");
    assertThat(values(element("double", bva(between("0.0", "10.0"), "0.5"))))
        .isEqualTo("-0.5* 0.0 0.5 5.0 9.5 10.0 10.5*");
  }

  @Test
  void oneBoundaryHasThreeBoundaryValues() {
    var below10 = new EquivalenceClass.OneBoundary(BigDecimal.TEN, false, false);
    assertThat(values(element("int", bva(below10, "1")))).isEqualTo("9 10* 11*");
  }

  @Test
  void removesDuplicates() {
    assertThat(values(element("int", bva(between("1", "2"), "1"), "2", "5")))
        .isEqualTo("0* 1 2 3* 5*");
  }

  @Test
  void roundsTheMiddleOfIntegersDown() {
    assertThat(values(element("int", bva(between("-4", "1"), "1")))).contains(" -2 ");
  }

  @Test
  void decimalStepsStayDecimal() {
    assertThat(values(element("double", bva(between("0.1", "0.7"), "0.1"))))
        .isEqualTo("0.0* 0.1 0.2 0.4 0.6 0.7 0.8*");
  }

  @Test
  void skipsAndReportsUnrepresentableValues() {
    TestData data = TestDataGenerator.generate(element("uint8", bva(between("0", "255"), "1")), 1);
    assertThat(data.unrepresentable()).containsExactly("-1", "256");
    assertThat(data.values()).allMatch(TestValue::valid).hasSize(5);
  }

  @Test
  void equivalenceClassesAreThoseOfTable1() {
    assertThat(values(element("int", ecp(between("0", "10"))))).isEqualTo("-1* 5 11*");
    assertThat(
            values(
                element(
                    "int", ecp(new EquivalenceClass.OneBoundary(BigDecimal.TEN, false, false)))))
        .isEqualTo("9 11*");
    assertThat(values(element("boolean", ecp(new EquivalenceClass.BooleanClass(false)))))
        .isEqualTo("false true");
    assertThat(values(element("boolean", ecp(new EquivalenceClass.BooleanClass(true)))))
        .isEqualTo("false* true");
    assertThat(values(element("int", ecp(new EquivalenceClass.Constant(new BigDecimal(3))))))
        .isEqualTo("3 4*");
    var set =
        new EquivalenceClass.NumericSet(
            List.of(new BigDecimal(-1), BigDecimal.ZERO, BigDecimal.ONE));
    assertThat(values(element("int", ecp(set)))).isEqualTo("0 2*");
  }

  @Test
  void aBooleanWithoutSpecificationHasBothValues() {
    assertThat(values(element("bool", null))).isEqualTo("false true");
  }

  @Test
  void userValuesWithoutSpecificationAreValid() {
    assertThat(values(element("int", null, "5", "-3"))).isEqualTo("-3 5");
  }

  @Property(tries = 200)
  void randomNumbersAreInRangeAndReproducible(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 50) int count) {
    TestSpec spec =
        new TestSpec.RandomNumbers(
            count,
            new BigDecimal("-2.5"),
            new BigDecimal("1e3"),
            new TestSpec.Distribution.Uniform(),
            TestSpec.Special.NONE);
    TestData data = TestDataGenerator.generate(element("double", spec), seed);
    assertThat(data.values()).hasSize(count).allMatch(TestValue::valid);
    assertThat(data.values())
        .allSatisfy(v -> assertThat(((Value.Real) v.value()).number()).isBetween(-2.5, 1000.0));
    assertThat(TestDataGenerator.generate(element("double", spec), seed)).isEqualTo(data);
  }

  @Property(tries = 50)
  void randomNumbersOfAFloatAreFloats(@ForAll long seed) {
    TestSpec spec =
        new TestSpec.RandomNumbers(
            20,
            new BigDecimal("0.1"),
            BigDecimal.ONE,
            new TestSpec.Distribution.Uniform(),
            TestSpec.Special.NONE);
    assertThat(TestDataGenerator.generate(element("float", spec), seed).values())
        .hasSize(20)
        .extracting(v -> v.value().literal())
        .allSatisfy(text -> assertThat(Float.toString(Float.parseFloat(text))).isEqualTo(text));
  }

  @Property(tries = 200)
  void validRandomStringsHaveBoundaryLengthsAndNoNegativeCharacters(@ForAll long seed) {
    TestSpec spec = new TestSpec.RandomStrings(3, 8, true, true, true, true, "a;9");
    List<TestValue> values = TestDataGenerator.generate(element("string", spec), seed).values();
    assertThat(values.stream().filter(TestValue::valid).map(v -> v.value().literal().length()))
        .containsExactly(3, 4, 5, 7, 8);
    assertThat(values)
        .filteredOn(TestValue::valid)
        .allMatch(v -> v.value().literal().chars().noneMatch(c -> "a;9".indexOf(c) >= 0));
    assertThat(values.stream().filter(v -> !v.valid()).map(v -> v.value().literal()))
        .hasSize(3)
        .anyMatch(text -> text.contains("a") && text.contains(";") && text.contains("9"))
        .anyMatch(text -> text.length() == 2)
        .anyMatch(text -> text.length() == 9);
  }

  @Test
  void anOperationalProfileGeneratesValuesInItsRanges() {
    TestSpec spec =
        new TestSpec.RandomNumbers(
            40,
            BigDecimal.ZERO,
            new BigDecimal(100),
            new TestSpec.Distribution.Weighted(
                List.of(
                    new TestSpec.WeightedRange(BigDecimal.ZERO, BigDecimal.TEN, 9),
                    new TestSpec.WeightedRange(new BigDecimal(90), new BigDecimal(100), 1))),
            TestSpec.Special.NONE);
    List<Double> numbers =
        TestDataGenerator.generate(element("double", spec), 1).values().stream()
            .map(v -> ((Value.Real) v.value()).number())
            .toList();
    assertThat(numbers).hasSize(40).allMatch(n -> n <= 10 || n >= 90);
    assertThat(numbers.stream().filter(n -> n <= 10).count()).isGreaterThan(25);
  }
}
