package org.sitaf.core.compare;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Groups differences by what they have in common, the largest group last: a single exception is not
 * hidden among many small differences.
 */
public final class DifferenceGroups {
  private final Map<String, List<ComparedCase>> casesOfModel = new LinkedHashMap<>();

  private DifferenceGroups(List<ComparedCase> cases) {
    cases.forEach(c -> casesOfModel.computeIfAbsent(c.model(), m -> new ArrayList<>()).add(c));
  }

  private record Key(DifferenceClass kind, String output, String change) {}

  /**
   * The groups of some differences.
   *
   * @param cases all compared cases, from which the conditions on inputs are derived
   */
  public static List<DifferenceGroup> of(List<Difference> differences, List<ComparedCase> cases) {
    DifferenceGroups groups = new DifferenceGroups(cases);
    Map<Key, List<Difference>> byKey = new LinkedHashMap<>();
    for (Difference found : differences) {
      byKey.computeIfAbsent(key(found), k -> new ArrayList<>()).add(found);
    }
    return byKey.entrySet().stream()
        .map(entry -> groups.group(entry.getKey(), entry.getValue()))
        .sorted(
            Comparator.<DifferenceGroup>comparingInt(g -> g.differences().size())
                .thenComparing(DifferenceGroup::kind)
                .thenComparing(DifferenceGroup::output))
        .toList();
  }

  private static Key key(Difference found) {
    return new Key(found.kind(), found.output(), found.change());
  }

  private DifferenceGroup group(Key key, List<Difference> found) {
    String where = String.join(" and ", conditions(found));
    return new DifferenceGroup(
        what(key, found) + (where.isEmpty() ? "" : " where " + where),
        key.kind(),
        key.output(),
        found);
  }

  private static String what(Key key, List<Difference> found) {
    int count = found.size();
    String cases = count == 1 ? "1 case" : count + " cases";
    return switch (key.kind()) {
      case VALUE, OBSERVED ->
          (count == 1 ? "1 value of " : count + " values of ")
              + key.output()
              + (key.change().isEmpty()
                  ? " differ" + (count == 1 ? "s" : "")
                  : (count == 1 ? " " : " up to ") + rounded(largest(found)) + " off");
      case ERROR ->
          count + " × " + key.change() + (key.output().isEmpty() ? "" : ", in " + key.output());
      case CALLS ->
          cases
              + (key.output().isEmpty()
                  ? " with another number of calls"
                  : " with other calls, first of " + key.output());
      case COMMANDS -> cases + " with other commands, first " + key.output() + at(found);
      case TRAJECTORY -> cases + " with another motion, first " + key.output() + at(found);
      case VERDICT -> count + " × " + key.change();
      case COVERAGE_LOST -> "lines of " + key.output() + " are no longer executed";
      case SLOWER -> cases + " slower";
    };
  }

  private static String at(List<Difference> found) {
    return found.stream()
        .flatMap(d -> Stream.ofNullable(d.at()))
        .min(Comparator.naturalOrder())
        .map(t -> " at " + t + " s")
        .orElse("");
  }

  private static double largest(List<Difference> found) {
    return found.stream().mapToDouble(Difference::deviation).max().orElse(Double.NaN);
  }

  /** Two significant digits of a finite number. */
  private static String rounded(double number) {
    if (!Double.isFinite(number)) {
      return Double.toString(number);
    }
    BigDecimal short2 = new BigDecimal(number).round(new MathContext(2)).stripTrailingZeros();
    return Math.abs(number) >= 1e-4 && Math.abs(number) < 1e7 || number == 0
        ? short2.toPlainString()
        : short2.toString();
  }

  /**
   * What the inputs of all cases of the group have in common and of other cases do not: a value, or
   * a bound of a number that separates them.
   */
  private List<String> conditions(List<Difference> found) {
    Set<String> inGroup = new HashSet<>();
    Set<String> models = new HashSet<>();
    found.forEach(
        d -> {
          inGroup.add(d.model() + " " + d.no());
          models.add(d.model());
        });
    List<Map<String, String>> others =
        models.stream()
            .flatMap(m -> casesOfModel.getOrDefault(m, List.of()).stream())
            .filter(c -> !inGroup.contains(c.model() + " " + c.no()))
            .map(ComparedCase::inputs)
            .toList();
    List<Map<String, String>> inputs = found.stream().map(Difference::inputs).toList();
    List<String> exact = new ArrayList<>();
    List<String> common = new ArrayList<>();
    List<String> names =
        inputs.get(0).keySet().stream()
            .filter(name -> inputs.stream().allMatch(i -> i.containsKey(name)))
            .toList();
    names.forEach(name -> new InputValues(name, inputs, others).describe(exact, common));
    if (exact.isEmpty()) {
      equalInputs(names, inputs, others).ifPresent(exact::add);
    }
    return exact.isEmpty() ? common : exact;
  }

  /** Two inputs that are equal in all cases of the group and in no other case. */
  private static Optional<String> equalInputs(
      List<String> names, List<Map<String, String>> inputs, List<Map<String, String>> others) {
    for (int i = 0; i < names.size(); i++) {
      for (int k = i + 1; k < names.size(); k++) {
        String first = names.get(i);
        String second = names.get(k);
        Predicate<Map<String, String>> equal =
            values -> Objects.equals(values.get(first), values.get(second));
        if (inputs.size() > 1
            && !others.isEmpty()
            && inputs.stream().allMatch(equal)
            && others.stream().noneMatch(equal)) {
          return Optional.of(first + " = " + second);
        }
      }
    }
    return Optional.empty();
  }
}
