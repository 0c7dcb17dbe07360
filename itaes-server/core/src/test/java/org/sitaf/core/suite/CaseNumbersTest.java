package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;

class CaseNumbersTest {
  private static TestSuite suite(int... numbers) {
    return new TestSuite(
        "S",
        "",
        "M",
        new Generation(new Strength(2), InvalidValues.ISOLATE, 1, "default", "", null, null),
        List.of(),
        IntStream.of(numbers)
            .mapToObj(no -> new TestCase(no, true, List.of(), List.of()))
            .toList());
  }

  private static List<Integer> numbers(TestSuite suite) {
    return suite.cases().stream().map(TestCase::no).toList();
  }

  @Test
  void selectsCasesInTheOrderOfTheSuite() {
    TestSuite selected = CaseNumbers.parse("12 - 20, 9").select(suite(3, 9, 11, 12, 15, 20, 21));
    assertThat(numbers(selected)).containsExactly(9, 12, 15, 20);
  }

  @Test
  void numbersWithinARangeMayBeMissing() {
    CaseNumbers numbers = CaseNumbers.parse("1-3,5,7-8");
    assertThat(numbers.missing(suite(1, 3, 4, 7))).hasToString("[5, 7-8]");
    assertThat(CaseNumbers.of(Set.of(4, 1)).missing(suite(1, 3, 4))).isEmpty();
  }

  @Test
  void mergesRangesThatOverlapOrTouch() {
    CaseNumbers numbers = CaseNumbers.parse("12-20,3,15-22,4,1,8-9");
    assertThat(numbers).hasToString("12-20,3,15-22,4,1,8-9");
    assertThat(numbers.merged()).hasToString("1,3-4,8-9,12-22");
    assertThat(CaseNumbers.of(Set.of(2, 1, 3, 7)).merged()).hasToString("1-3,7");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "0", "3-", "-3", "5-3", "1,,2", "x", "99999999999"})
  void rejectsOtherText(String text) {
    assertThatThrownBy(() -> CaseNumbers.parse(text)).isInstanceOf(IllegalArgumentException.class);
  }
}
