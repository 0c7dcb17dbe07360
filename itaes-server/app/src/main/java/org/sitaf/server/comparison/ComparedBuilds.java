package org.sitaf.server.comparison;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceGroup;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.Provenance;

/**
 * The comparison of two builds, without what pages do not show.
 *
 * @param cases number of cases that both builds executed
 * @param groups of the differences, the largest last
 * @param numbers of cases in the base result by those in the new one, where they differ
 * @param otherTools packages and tools that the builds do not share
 */
record ComparedBuilds(
    List<CaseParameter> parameters,
    Provenance base,
    Provenance now,
    int cases,
    int differingCases,
    List<Difference> differences,
    List<DifferenceGroup> groups,
    List<Difference> lastBits,
    List<Difference> slower,
    List<NotComparable> notComparable,
    Map<Integer, Integer> numbers,
    List<String> otherTools) {

  static ComparedBuilds of(
      Comparison comparison,
      List<CaseParameter> parameters,
      Provenance base,
      Provenance now,
      Map<Integer, Integer> numbers,
      List<String> otherTools) {
    Set<Integer> differing =
        comparison.differences().stream()
            .map(Difference::no)
            .filter(no -> no > 0)
            .collect(Collectors.toSet());
    return new ComparedBuilds(
        parameters,
        base,
        now,
        comparison.cases().size(),
        differing.size(),
        comparison.differences(),
        comparison.groups(),
        comparison.lastBits(),
        comparison.slower(),
        comparison.notComparable(),
        numbers.entrySet().stream()
            .filter(e -> !e.getKey().equals(e.getValue()))
            .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue)),
        otherTools);
  }

  /** The number of a case in the base result. */
  int numberInBase(int no) {
    return numbers.getOrDefault(no, no);
  }

  /** What it occupies in a cache. */
  int weight() {
    return 1
        + differences.size()
        + lastBits.size()
        + slower.size()
        + notComparable.size()
        + numbers.size();
  }
}
