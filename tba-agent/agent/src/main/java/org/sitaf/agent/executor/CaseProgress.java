package org.sitaf.agent.executor;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;

/** Which cases of a suite have a result, and which is next. Cases run in the order of the suite. */
final class CaseProgress {
  private final List<TestCase> cases;
  private final Set<Integer> numbers = new HashSet<>();
  private final Map<Integer, CaseResult> results = new HashMap<>();
  private final UnaryOperator<CaseResult> onResult;
  private final OutputSink sink;
  private int next;

  /**
   * Nothing has a result yet.
   *
   * @param onResult is told each result, and may judge it differently
   */
  CaseProgress(TestSuite suite, UnaryOperator<CaseResult> onResult, OutputSink sink) {
    this.cases = suite.cases();
    this.onResult = onResult;
    this.sink = sink;
    cases.forEach(testCase -> numbers.add(testCase.no()));
  }

  boolean isComplete() {
    return next == cases.size();
  }

  /** The case that is at work, or would be. */
  TestCase current() {
    return cases.get(next);
  }

  int count() {
    return results.size();
  }

  /**
   * Takes a line of the results file; a line that is none is remarked in the log and changes
   * nothing.
   */
  void acceptLine(String line) {
    CaseResult result;
    try {
      result = TestResultXml.readCase(line);
    } catch (InvalidInputException e) {
      sink.remark(
          "a line of the results file is not a test_result and was left out: " + e.getMessage());
      return;
    }
    if (!numbers.contains(result.no())) {
      sink.remark(
          "a result of case " + result.no() + ", which the suite does not hold, was left out");
    } else if (results.containsKey(result.no())) {
      sink.remark("a second result of case " + result.no() + " was left out");
    } else {
      accept(result);
    }
  }

  /** The current case ended with an error that the test application could not record itself. */
  void currentFailed(String message) {
    TestCase testCase = current();
    accept(
        new CaseResult(
            testCase.no(),
            Verdict.ERROR,
            testCase.values(),
            testCase.expected().stream()
                .map(expected -> new NamedValue(expected.output(), expected.literal()))
                .toList(),
            List.of(),
            null,
            message));
  }

  private void accept(CaseResult result) {
    results.put(result.no(), onResult.apply(result));
    while (next < cases.size() && results.containsKey(cases.get(next).no())) {
      next++;
    }
  }

  /** All results so far, in the order of the suite. */
  List<CaseResult> results() {
    List<CaseResult> inOrder = new ArrayList<>();
    for (TestCase testCase : cases) {
      CaseResult result = results.get(testCase.no());
      if (result != null) {
        inOrder.add(result);
      }
    }
    return inOrder;
  }
}
