package org.sitaf.core.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.timing.TimeComparison;

/** Finds the cases whose repeated calls are slower with the new version. */
public final class SlowerCases {
  private final CaseComparison comparison;
  private final TestSuite suite;

  /** Prepares the search in the cases of a suite. */
  public SlowerCases(CaseComparison comparison, TestSuite suite) {
    this.comparison = comparison;
    this.suite = suite;
  }

  /** Provides the execution of a case. */
  @FunctionalInterface
  public interface Runs {
    /** The execution of a case. */
    CaseRun of(int no);
  }

  /** The slower cases, with the medians in microseconds. */
  public List<Difference> find(Runs base, Runs now) {
    List<TestCase> cases = new ArrayList<>();
    List<TimeComparison.Pair> pairs = new ArrayList<>();
    for (TestCase testCase : suite.cases()) {
      RepeatedCalls before = base.of(testCase.no()).result().repeated();
      RepeatedCalls after = now.of(testCase.no()).result().repeated();
      if (before != null && after != null && before.calls() > 0 && after.calls() > 0) {
        cases.add(testCase);
        pairs.add(new TimeComparison.Pair(before, after));
      }
    }
    List<TimeComparison.Change> changes = TimeComparison.of(pairs);
    List<Difference> slower = new ArrayList<>();
    for (int i = 0; i < pairs.size(); i++) {
      if (changes.get(i).slower()) {
        slower.add(difference(cases.get(i), pairs.get(i)));
      }
    }
    return slower;
  }

  private Difference difference(TestCase testCase, TimeComparison.Pair pair) {
    double before = Objects.requireNonNull(pair.before().median());
    double after = Objects.requireNonNull(pair.now().median());
    return new Difference(
        suite.modelName(),
        testCase.no(),
        testCase.valid(),
        DifferenceClass.SLOWER,
        "",
        comparison.inputs(testCase),
        Double.toString(before),
        Double.toString(after),
        null,
        "",
        after - before);
  }
}
