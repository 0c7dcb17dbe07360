package org.sitaf.cli.bisect;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import org.sitaf.cli.bisect.VersionTests.Tested;
import org.sitaf.cli.compare.Run;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.core.compare.CaseComparison;
import org.sitaf.core.compare.CaseDifferences;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceClass;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * A version is bad if it gives other values than the good version where the bad version does.
 *
 * @param bad declares the types of outputs that its models do not name
 * @param signs what is different in the bad version
 */
record OtherValues(
    Activity bad, Map<TestModel, TestSuite> suites, Tested good, Map<TestModel, Set<Sign>> signs)
    implements Criterion {
  private static final int ULP = 4;

  /** A difference in a case. */
  record Sign(int no, DifferenceClass kind, String output) {
    static Sign of(Difference difference) {
      return new Sign(difference.no(), difference.kind(), difference.output());
    }
  }

  /** The differences between the good and the bad version. */
  static OtherValues between(
      Activity bad, Map<TestModel, TestSuite> suites, Tested good, Tested ofBad) {
    Map<TestModel, Set<Sign>> signs = new LinkedHashMap<>();
    OtherValues none = new OtherValues(bad, suites, good, Map.of());
    for (TestModel model : suites.keySet()) {
      Set<Sign> found = new LinkedHashSet<>();
      for (TestCase testCase : none.suite(model).cases()) {
        none.compare(model, testCase, ofBad).differences().forEach(d -> found.add(Sign.of(d)));
      }
      if (!found.isEmpty()) {
        signs.put(model, found);
      }
    }
    return new OtherValues(bad, suites, good, signs);
  }

  boolean isEmpty() {
    return signs.isEmpty();
  }

  private TestSuite suite(TestModel model) {
    return Objects.requireNonNull(suites.get(model));
  }

  private CaseDifferences compare(TestModel model, TestCase testCase, Tested other) {
    Run before = Objects.requireNonNull(good.runs().get(model));
    Run after = Objects.requireNonNull(other.runs().get(model));
    return new CaseComparison(bad, model, suite(model), ULP, false)
        .compare(testCase, before.of(testCase.no()), after.of(testCase.no()));
  }

  @Override
  public Decision decide(Tested tested) {
    if (!tested.problem().isEmpty()) {
      return new Decision(Outcome.SKIPPED, tested.problem());
    }
    Decision decision = Decision.GOOD;
    for (Map.Entry<TestModel, Set<Sign>> entry : signs.entrySet()) {
      Set<Integer> numbers = numbers(entry.getValue());
      for (TestCase testCase : suite(entry.getKey()).cases()) {
        if (!numbers.contains(testCase.no())) {
          continue;
        }
        CaseDifferences found = compare(entry.getKey(), testCase, tested);
        for (Difference difference : found.differences()) {
          if (entry.getValue().contains(Sign.of(difference))) {
            return new Decision(Outcome.BAD, text(difference));
          }
        }
        if (!found.isCompared()) {
          decision = new Decision(Outcome.SKIPPED, "case " + testCase.no() + " cannot be compared");
        }
      }
    }
    return decision;
  }

  private static String text(Difference difference) {
    return "case %d: %s%s instead of %s"
        .formatted(
            difference.no(),
            difference.output().isEmpty() ? "" : difference.output() + " is ",
            difference.now(),
            difference.base());
  }

  private static Set<Integer> numbers(Set<Sign> signs) {
    Set<Integer> numbers = new TreeSet<>();
    signs.forEach(sign -> numbers.add(sign.no()));
    return numbers;
  }

  @Override
  public String text() {
    Map<TestModel, Set<Integer>> cases = new LinkedHashMap<>();
    signs.forEach((model, found) -> cases.put(model, numbers(found)));
    return "gives other values than GOOD: " + Criterion.numbers(cases);
  }
}
