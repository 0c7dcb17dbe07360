package org.sitaf.core.compare;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Decides whether differences between two versions are caused by the versions: the differing cases
 * run {@link #RUNS} more times with each version. A difference counts if all runs of each version
 * agree.
 */
public final class Confirmation {
  /** Further runs of each version. */
  public static final int RUNS = 8;

  private final List<Difference> found;
  private final Disagreements fromFirst = new Disagreements();
  private final Disagreements amongFurther = new Disagreements();

  /** What is known about a difference. */
  public enum Decision {
    /** All runs of each version agree. */
    CONFIRMED,
    /**
     * The further runs of each version agree, but not with the first one, in which other cases ran
     * before: the component keeps a state between cases, or the first run was an accident.
     */
    DEPENDS_ON_OTHER_CASES,
    /** Runs of the same version disagree. */
    UNSTABLE
  }

  /**
   * Begins a confirmation.
   *
   * @param found the differences between the first runs of both versions
   */
  public Confirmation(List<Difference> found) {
    this.found = List.copyOf(found);
  }

  /**
   * Adds a case of a further run of one of the versions.
   *
   * @param fromFirstRun how it differs from the first run of the same version
   * @param fromFurtherRun how it differs from the first one of the further runs of that version
   */
  public void add(List<Difference> fromFirstRun, List<Difference> fromFurtherRun) {
    fromFirst.add(fromFirstRun);
    amongFurther.add(fromFurtherRun);
  }

  /** The decision by the runs so far; only {@link Decision#UNSTABLE} never changes. */
  public Decision of(Difference difference) {
    if (amongFurther.castDoubtOn(difference)) {
      return Decision.UNSTABLE;
    }
    return fromFirst.castDoubtOn(difference) ? Decision.DEPENDS_ON_OTHER_CASES : Decision.CONFIRMED;
  }

  /** Whether a further run can change a decision. */
  public boolean isOpen() {
    return found.stream().anyMatch(d -> of(d) != Decision.UNSTABLE);
  }

  /** The differences with a decision. */
  public List<Difference> all(Decision decision) {
    return found.stream().filter(d -> of(d) == decision).toList();
  }

  /** Differences between runs of the same version. */
  private static final class Disagreements {
    private final Map<Integer, List<Difference>> ofCase = new HashMap<>();

    void add(List<Difference> some) {
      some.forEach(d -> ofCase.computeIfAbsent(d.no(), no -> new ArrayList<>()).add(d));
    }

    boolean castDoubtOn(Difference difference) {
      return ofCase.getOrDefault(difference.no(), List.of()).stream()
          .anyMatch(disagreement -> disagreement.castsDoubtOn(difference));
    }
  }
}
