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
 * Tracks which cases of a suite have a result and which is next. Cases run in the order of the
 * suite. Unexpected lines of a test application are ignored and make the result suspect.
 */
final class CaseProgress implements ResultsChannel.Lines {
  /** Memory for all results, in addition to that of each case. */
  private static final long MAX_BYTES = 256L << 20;

  private static final long MAX_BYTES_OF_CASE = 4096;

  /** Reading stops after this many bytes of unexpected lines. */
  private static final long MAX_SUSPICIOUS_BYTES = 16L << 20;

  /** Two processes read their clocks at different times. */
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
   * Creates a progress without results.
   *
   * @param onResult receives each result and may change its verdict
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

  /** The running case, or the next one. */
  TestCase current() {
    return cases.get(next);
  }

  int count() {
    return results.size();
  }

  /** Reasons why the results cannot be trusted; empty if they can. */
  List<String> suspicions() {
    return suspicions.reasons();
  }

  void suspect(String reason) {
    suspicions.add(reason);
  }

  /** A new process starts, which is not ready yet. */
  void beginProcess() {
    ready = false;
  }

  /** Whether the process has reported that it is ready for its first case. */
  boolean isReady() {
    return ready;
  }

  /** Sets the run time of the process, an upper bound for each call. */
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

  /** Why no further result is read; empty if results are read. */
  String whyFull() {
    return full;
  }

  @Override
  public void suspicious(String reason, int length) {
    suspicions.add(reason);
    countSuspicious(length);
  }

  @Override
  public void omitted(int length) {
    countSuspicious(length);
    if (isFull()) {
      suspicions.add("an unterminated line");
    }
  }

  private void countSuspicious(int length) {
    suspiciousBytes += length;
    if (suspiciousBytes > MAX_SUSPICIOUS_BYTES) {
      full =
          "the results channel contained more than "
              + (MAX_SUSPICIOUS_BYTES >> 20)
              + " MiB of unexpected lines";
    }
  }

  @Override
  public void tooLong() {
    if (!isComplete()) {
      currentFailed(
          "the result of this case is longer than "
              + (ResultsChannel.MAX_LINE >> 20)
              + " MiB; reduce the size of the outputs");
    }
  }

  /** A line of the driver, which a component in the same process may have changed. */
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
      suspicious("a result of a case that is not in the suite", line.length());
    } else if (results.containsKey(result.no())) {
      suspicious("a second result of a case", line.length());
    } else {
      if (testCase != current()) {
        suspicions.add("results arrived in another order than the cases of the suite");
      }
      bytes += line.length();
      if (bytes > maxBytes) {
        full = "the results exceed " + (maxBytes >> 20) + " MiB";
      }
      accept(checked(testCase, result));
    }
  }

  /** Replaces the values by those of the suite and checks the processing time. */
  private CaseResult checked(TestCase testCase, CaseResult result) {
    CaseResult checked = result;
    ReportedCase reported = new ReportedCase(testCase, result);
    if (!reported.isOfSuite()) {
      suspicions.add("a result has other input or expected values than its case");
      checked = reported.withValuesOfSuite();
    }
    CaseResult.ProcessingTime time = result.time();
    if (time != null && !isPossible(time)) {
      suspicions.add(
          "a result has a processing time that is negative or exceeds the run time of its process ("
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

  /** Records an error for the current case, which the test application could not report. */
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

  /** All results so far, sorted like the suite. */
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
