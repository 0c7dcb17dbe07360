package org.sitaf.agent.executor;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.ReportedCase;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;

/**
 * Which cases of a suite have a result, and which is next. Cases run in the order of the suite.
 * What a test application writes that does not fit is left out, and makes the result suspect.
 */
final class CaseProgress implements ResultsChannel.Lines {
  /** Room of what is kept of all results, beyond what each case may take. */
  private static final long MAX_BYTES = 256L << 20;

  private static final long MAX_BYTES_OF_CASE = 4096;

  /** After so much that is no result, no more of it is read. */
  private static final long MAX_SUSPICIOUS_BYTES = 16L << 20;

  /** Clocks of two processes are read at different times. */
  private static final double CLOCK_TOLERANCE_US = 1000;

  private static final double US_IN_SECOND = 1e6;

  private final List<TestCase> cases;
  private final Map<Integer, TestCase> byNumber = new HashMap<>();
  private final Map<Integer, CaseResult> results = new HashMap<>();
  private final UnaryOperator<CaseResult> onResult;
  private final Suspicions suspicions;
  private final long maxBytes;
  private long bytes;
  private long suspiciousBytes;
  private String full = "";
  private boolean ready;
  private double elapsedUs = Double.POSITIVE_INFINITY;
  private int next;

  /**
   * Nothing has a result yet.
   *
   * @param onResult is told each result, and may judge it differently
   */
  CaseProgress(TestSuite suite, UnaryOperator<CaseResult> onResult, OutputSink sink) {
    this.cases = suite.cases();
    this.onResult = onResult;
    this.suspicions = new Suspicions(sink);
    this.maxBytes = MAX_BYTES + MAX_BYTES_OF_CASE * cases.size();
    cases.forEach(testCase -> byNumber.put(testCase.no(), testCase));
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

  /** Why the results are not to be trusted; empty where they are. */
  List<String> suspicions() {
    return suspicions.reasons();
  }

  void suspect(String reason) {
    suspicions.add(reason);
  }

  /** A fresh process begins, which is not ready. */
  void beginProcess() {
    ready = false;
  }

  /** Whether the process said that it is ready for its first case. */
  boolean isReady() {
    return ready;
  }

  /** How long the process has run, at most; no call took longer. */
  void processHasRun(double microseconds) {
    elapsedUs = microseconds;
  }

  @Override
  public void ready() {
    ready = true;
  }

  @Override
  public boolean isFull() {
    return !full.isEmpty();
  }

  /** Why no further result is read; empty where any is. */
  String whyFull() {
    return full;
  }

  @Override
  public void suspicious(String reason, int length) {
    suspicions.add(reason);
    countSuspicious(length);
  }

  @Override
  public void leftOut(int length) {
    countSuspicious(length);
    if (isFull()) {
      suspicions.add("a line without end");
    }
  }

  private void countSuspicious(int length) {
    suspiciousBytes += length;
    if (suspiciousBytes > MAX_SUSPICIOUS_BYTES) {
      full =
          "the results channel held more than "
              + (MAX_SUSPICIOUS_BYTES >> 20)
              + " MiB that are no results";
    }
  }

  @Override
  public void tooLong() {
    if (!isComplete()) {
      currentFailed(
          "the result of this case is longer than "
              + (ResultsChannel.MAX_LINE >> 20)
              + " MiB; let the outputs hold less");
    }
  }

  /** A line that a driver wrote; a component that shares its process may have changed it. */
  @Override
  public void content(String line) {
    ready = true;
    CaseResult result;
    try {
      result = TestResultXml.readCase(line);
    } catch (InvalidInputException e) {
      suspicious("a numbered line is not a test_result: " + e.getMessage(), line.length());
      return;
    }
    TestCase testCase = byNumber.get(result.no());
    if (testCase == null) {
      suspicious("a result of a case that the suite does not hold", line.length());
    } else if (results.containsKey(result.no())) {
      suspicious("a second result of a case", line.length());
    } else {
      if (testCase != current()) {
        suspicions.add("results came in another order than the cases of the suite");
      }
      bytes += line.length();
      if (bytes > maxBytes) {
        full = "the results are larger than " + (maxBytes >> 20) + " MiB together";
      }
      accept(checked(testCase, result));
    }
  }

  /** The result with the suite's own values, and a time that can be true. */
  private CaseResult checked(TestCase testCase, CaseResult result) {
    CaseResult checked = result;
    ReportedCase reported = new ReportedCase(testCase, result);
    if (!reported.isOfSuite()) {
      suspicions.add("a result has other values, or expects other values, than its case");
      checked = reported.withValuesOfSuite();
    }
    CaseResult.ProcessingTime time = result.time();
    if (time != null && !isPossible(time)) {
      suspicions.add(
          "a result has a processing time that is negative, or longer than its process ran ("
              + Math.round(elapsedUs / US_IN_SECOND)
              + " s)");
      checked = reported.withValuesOfSuite().withoutTime();
    }
    return checked;
  }

  private boolean isPossible(CaseResult.ProcessingTime time) {
    double all = time.total() + time.hardware() + time.stub();
    return time.total() >= 0
        && time.hardware() >= 0
        && time.stub() >= 0
        && all <= elapsedUs + CLOCK_TOLERANCE_US;
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
