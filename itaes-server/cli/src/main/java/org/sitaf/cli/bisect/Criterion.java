package org.sitaf.cli.bisect;

import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.cli.bisect.VersionTests.Tested;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.core.model.TestModel;

/** Decides whether a version is bad. */
sealed interface Criterion permits FailingCases, OtherValues {
  /** Cases that a message lists. */
  int SHOWN = 10;

  /**
   * A decision.
   *
   * @param reason the first case that is bad, or why the version cannot be tested; empty if good
   */
  record Decision(Outcome outcome, String reason) {
    static final Decision GOOD = new Decision(Outcome.GOOD, "");
  }

  /** Decides by the execution of a version. */
  Decision decide(Tested tested);

  /** What a bad version does, with the cases. */
  String text();

  /** The numbers of cases by model, for a message. */
  static String numbers(Map<TestModel, Set<Integer>> cases) {
    return cases.entrySet().stream()
        .map(
            e ->
                e.getKey().name()
                    + (e.getValue().size() == 1 ? ", case " : ", cases ")
                    + e.getValue().stream()
                        .limit(SHOWN)
                        .map(String::valueOf)
                        .collect(Collectors.joining(", "))
                    + (e.getValue().size() > SHOWN ? ", ..." : ""))
        .collect(Collectors.joining("; "));
  }
}
