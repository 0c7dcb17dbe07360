package org.sitaf.core.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.sitaf.core.verdict.Literals;

/** The values of one input in the cases of a group and in the other cases. */
record InputValues(
    String name, List<Map<String, String>> ofGroup, List<Map<String, String>> ofOthers) {
  /**
   * Describes the values of the group.
   *
   * @param exact gets the condition that the group fulfils and no other case does
   * @param common gets the condition that at most half of the other cases fulfil, too
   */
  void describe(List<String> exact, List<String> common) {
    List<String> values = values(ofGroup).distinct().toList();
    List<String> others = values(ofOthers).distinct().toList();
    if (others.isEmpty() || values.containsAll(others) && others.containsAll(values)) {
      return;
    }
    if (values.size() == 1) {
      long same = values(ofOthers).filter(values.get(0)::equals).count();
      if (same == 0) {
        exact.add(name + " = " + values.get(0));
      } else if (2 * same <= ofOthers.size()) {
        common.add(name + " = " + values.get(0));
      }
      return;
    }
    if (!Stream.concat(values.stream(), others.stream()).allMatch(Literals::isReal)) {
      return;
    }
    List<Double> inside = numbers(values);
    List<Double> outside = numbers(others);
    if (inside.get(0) > outside.get(outside.size() - 1)) {
      exact.add(name + " ≥ " + literal(values, inside.get(0)));
    } else if (inside.get(inside.size() - 1) < outside.get(0)) {
      exact.add(name + " ≤ " + literal(values, inside.get(inside.size() - 1)));
    }
  }

  private Stream<String> values(List<Map<String, String>> cases) {
    return cases.stream().flatMap(c -> Stream.ofNullable(c.get(name)));
  }

  private static List<Double> numbers(List<String> literals) {
    List<Double> numbers = new ArrayList<>();
    literals.forEach(literal -> numbers.add(Literals.real(literal)));
    numbers.sort(null);
    return numbers;
  }

  private static String literal(List<String> literals, double number) {
    return literals.stream()
        .filter(literal -> Double.compare(Literals.real(literal), number) == 0)
        .findFirst()
        .orElse(Double.toString(number));
  }
}
