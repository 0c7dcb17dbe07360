package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class DifferenceGroupsTest {
  private static Map<String, String> inputs(int no) {
    Map<String, String> inputs = new LinkedHashMap<>();
    inputs.put("speed", no % 2 == 0 ? "2" : "1");
    inputs.put("distance", no + ".5");
    inputs.put("remove", Boolean.toString(no == 7));
    return inputs;
  }

  private static List<ComparedCase> cases() {
    List<ComparedCase> cases = new ArrayList<>();
    for (int no = 1; no <= 12; no++) {
      cases.add(new ComparedCase("M", no, inputs(no)));
    }
    return cases;
  }

  private static Difference value(int no, double deviation) {
    return difference(no, DifferenceClass.VALUE, "return", "numbers", deviation);
  }

  private static Difference difference(
      int no, DifferenceClass kind, String output, String change, double deviation) {
    return new Difference(
        "M", no, true, kind, output, inputs(no), "a", "b", null, change, deviation);
  }

  private static List<String> texts(Difference... differences) {
    return DifferenceGroups.of(List.of(differences), cases()).stream()
        .map(DifferenceGroup::text)
        .toList();
  }

  @Test
  void theLargestGroupIsLast() {
    Difference error = difference(7, DifferenceClass.ERROR, "", "NoEcho in NEW only", Double.NaN);
    assertThat(texts(value(2, 0.001), error, value(4, 0.00312), value(6, 0.002)))
        .containsExactly(
            "1 × NoEcho in NEW only where distance = 7.5 and remove = true",
            "3 values of return up to 0.0031 off where speed = 2");
  }

  @Test
  void aValueThatOnlyTheGroupHasIsItsCondition() {
    assertThat(
            texts(value(2, 1), value(4, 1), value(6, 1), value(8, 1), value(10, 1), value(12, 1)))
        .containsExactly("6 values of return up to 1 off where speed = 2");
  }

  @Test
  void aBoundThatSeparatesTheGroupIsItsCondition() {
    assertThat(texts(value(10, 1), value(11, 1), value(12, 2e9)))
        .containsExactly("3 values of return up to 2E+9 off where distance ≥ 10.5");
    assertThat(texts(value(1, 1), value(2, 1)))
        .containsExactly("2 values of return up to 1 off where distance ≤ 2.5");
  }

  @Test
  void inputsThatAreEqualInTheGroupOnlyAreItsCondition() {
    List<ComparedCase> cases = new ArrayList<>();
    List<Difference> differences = new ArrayList<>();
    for (int no = 0; no < 16; no++) {
      Map<String, String> inputs = new LinkedHashMap<>();
      inputs.put("index", Integer.toString(no / 4));
      inputs.put("size", Integer.toString(no % 4));
      cases.add(new ComparedCase("M", no + 1, inputs));
      if (no / 4 == no % 4) {
        differences.add(
            new Difference(
                "M",
                no + 1,
                true,
                DifferenceClass.VALUE,
                "return",
                inputs,
                "a",
                "b",
                null,
                "numbers",
                1));
      }
    }
    assertThat(DifferenceGroups.of(differences, cases))
        .extracting(DifferenceGroup::text)
        .containsExactly("4 values of return up to 1 off where index = size");
  }

  @Test
  void allCasesHaveNoCondition() {
    Difference[] all = cases().stream().map(c -> value(c.no(), 1)).toArray(Difference[]::new);
    assertThat(texts(all)).containsExactly("12 values of return up to 1 off");
  }

  @Test
  void textsOfOtherKinds() {
    assertThat(texts(difference(1, DifferenceClass.VALUE, "name", "", Double.NaN)).get(0))
        .startsWith("1 value of name differs where distance = 1.5");
    Difference moved =
        new Difference(
            "M",
            1,
            true,
            DifferenceClass.TRAJECTORY,
            "robot_x",
            inputs(1),
            "0.0",
            "1.0",
            1.25,
            "numbers",
            1);
    assertThat(texts(moved).get(0))
        .startsWith("1 case with another motion, first robot_x at 1.25 s");
  }
}
