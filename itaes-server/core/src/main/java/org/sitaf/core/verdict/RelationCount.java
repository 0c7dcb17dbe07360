package org.sitaf.core.verdict;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * In how many cases a relation was checked.
 *
 * @param checked number of cases in which it holds or is broken
 * @param broken number of cases in which it is broken
 * @param skipped number of cases to which it does not apply
 * @param errors number of cases in which it could not be checked
 */
public record RelationCount(String name, int checked, int broken, int skipped, int errors) {
  public RelationCount {
    Objects.requireNonNull(name);
  }

  /** The counts of the relations of a model, in its order. */
  public static List<RelationCount> of(List<CaseResult> cases) {
    Map<String, RelationCount> counts = new LinkedHashMap<>();
    for (CaseResult result : cases) {
      for (RelationResult relation : result.relations()) {
        counts.merge(relation.name(), of(relation), RelationCount::plus);
      }
    }
    return List.copyOf(counts.values());
  }

  private static RelationCount of(RelationResult result) {
    return switch (result.outcome()) {
      case PASS -> new RelationCount(result.name(), 1, 0, 0, 0);
      case FAIL -> new RelationCount(result.name(), 1, 1, 0, 0);
      case SKIPPED -> new RelationCount(result.name(), 0, 0, 1, 0);
      case ERROR -> new RelationCount(result.name(), 0, 0, 0, 1);
    };
  }

  private RelationCount plus(RelationCount other) {
    return new RelationCount(
        name,
        checked + other.checked,
        broken + other.broken,
        skipped + other.skipped,
        errors + other.errors);
  }
}
