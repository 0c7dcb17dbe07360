package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

/** The paper's example, whose complete suite has 55 cases, with fewer cases. */
class CaseLimitTest {
  private static GeneratedSuite generate(int maxCases, int strength, InvalidValues invalidValues) {
    TestModel model;
    try (InputStream document =
        Objects.requireNonNull(
            CaseLimitTest.class.getResourceAsStream("/models/GetInfraredData.xml"))) {
      model = TestModelXml.read(document, "GetInfraredData.xml");
    } catch (java.io.IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
    return TestCaseGenerator.generate(
        model,
        new GenerationOptions(
            new Strength(strength), invalidValues, 1, Effort.DEFAULT, null, maxCases));
  }

  /** Pairs of valid values in valid cases, and invalid values with a valid one. */
  private static long pairs(TestSuite suite, Set<String> invalid) {
    Set<List<Object>> pairs = new HashSet<>();
    for (TestCase testCase : suite.cases()) {
      for (int i = 0; i < 3; i++) {
        for (int j = i + 1; j < 3; j++) {
          String one = testCase.values().get(i);
          String other = testCase.values().get(j);
          boolean holdsInvalid = invalid.contains(i + one) || invalid.contains(j + other);
          if (testCase.valid() || holdsInvalid) {
            pairs.add(List.of(i, one, j, other));
          }
        }
      }
    }
    return pairs.size();
  }

  private static final Set<String> INVALID = Set.of("00", "08", "10", "18", "2-0.5", "210.5");

  @ParameterizedTest
  @ValueSource(ints = {11, 20, 30, 54})
  void asManyTuplesAsFitAreCovered(int maxCases) {
    GeneratedSuite generated = generate(maxCases, 2, InvalidValues.ISOLATE);
    TestSuite suite = generated.suite();
    assertThat(suite.cases()).hasSize(maxCases);
    for (int p = 0; p < 3; p++) {
      int column = p;
      assertThat(suite.cases().stream().map(c -> c.values().get(column)).distinct()).hasSize(7);
    }
    assertThat(suite.cases().stream().filter(c -> !c.valid()))
        .allMatch(
            c ->
                java.util.stream.IntStream.range(0, 3)
                        .filter(i -> INVALID.contains(i + c.values().get(i)))
                        .count()
                    == 1);
    Generation.Tuples tuples = Objects.requireNonNull(suite.generation().tuples());
    assertThat(tuples.all()).isEqualTo(75 + 60);
    assertThat(tuples.covered()).isEqualTo(pairs(suite, INVALID));
    assertThat(generated.notes().toString()).contains("of 135 tuples are covered");
  }

  @Test
  void aBoundThatIsLargeEnoughChangesNothing() {
    TestSuite suite = generate(55, 2, InvalidValues.ISOLATE).suite();
    assertThat(suite.cases()).hasSize(55);
    assertThat(suite.generation().tuples()).isEqualTo(new Generation.Tuples(135, 135));
  }

  @Test
  void aBoundThatIsTooSmallIsAnErrorWithTheSmallestNumber() {
    assertThatThrownBy(() -> generate(10, 2, InvalidValues.ISOLATE))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("the smallest number of cases that the generator found is 11");
    assertThatThrownBy(() -> generate(6, 2, InvalidValues.COMBINE))
        .hasMessageContaining("generator found is 7");
  }

  @Test
  void combinedInvalidValuesCountLikeAllOthers() {
    TestSuite suite = generate(20, 2, InvalidValues.COMBINE).suite();
    Generation.Tuples tuples = Objects.requireNonNull(suite.generation().tuples());
    assertThat(tuples.all()).isEqualTo(3 * 49);
    assertThat(tuples.covered()).isEqualTo(60);
  }

  @Test
  void allCombinationsAreBoundedToo() {
    TestSuite suite = generate(40, 3, InvalidValues.ISOLATE).suite();
    assertThat(suite.cases()).hasSize(40);
    // 125 triples of valid values, and 25 pairs for each of six invalid values.
    assertThat(suite.generation().tuples()).isEqualTo(new Generation.Tuples(40, 275));
  }

  /** Of all pairs, only 3 in 43 are nearly equal. */
  @Test
  void nearlyEqualInputsAreNotLostAmongOtherCombinations() {
    TestModel model =
        TestModelXml.read(
            new ByteArrayInputStream(
                """
                <test_model><name>Near</name><target interface="I" method="Near"/><input_spec_list>
                <test_element abstract_type="NUMERIC" real_type="double"><name>a</name><type>TDI</type>
                  <test_spec type="RANDOM" count="40" min="0" max="1"/></test_element>
                <test_element abstract_type="NUMERIC" real_type="double"><name>b</name><type>TDI</type>
                  <test_spec type="RANDOM" count="40" min="0" max="1"/>
                  <test_spec type="RELATED" to="a" offsets="0 1e-300 1e-9"/></test_element>
                </input_spec_list><output_spec_list/><order_of_combinations>2</order_of_combinations>
                <max_cases>100</max_cases></test_model>
                """
                    .getBytes(StandardCharsets.UTF_8)),
            "Near.xml");
    List<TestCase> cases =
        TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite().cases();
    // Pairs that are equal after 1e-300 was added are made once, and others take their place.
    assertThat(cases).hasSize(100);
    assertThat(cases.stream().map(TestCase::values)).doesNotHaveDuplicates();
    assertThat(cases)
        .filteredOn(
            c ->
                Math.abs(
                        Double.parseDouble(c.values().get(0))
                            - Double.parseDouble(c.values().get(1)))
                    <= 1.1e-9)
        .hasSizeGreaterThan(25);
  }
}
