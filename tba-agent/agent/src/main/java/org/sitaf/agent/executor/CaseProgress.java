package org.sitaf.agent.executor;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.timing.Timing;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.document.CaseRecordLine;

/**
 * Tracks which cases of a suite have a result and which is next. Cases run in the order of the
 * suite. Unexpected lines of a test application are ignored and make the result suspect.
 */
final class CaseProgress implements ResultsChannel.Lines {
  /** Memory for all results, in addition to that of each case. */
  private static final long MAX_BYTES = 256L << 20;

  private static final long MAX_BYTES_OF_CASE = 4096;

  /** Memory for the time of a repeated call in a record. */
  private static final long MAX_BYTES_OF_CALL = 16;

  /** Reading stops after this many bytes of unexpected lines. */
  private static final long MAX_SUSPICIOUS_BYTES = 16L << 20;

  /** Two processes read their clocks at different times. */
  private static final double CLOCK_TOLERANCE_US = 1000;

  private static final double US_IN_SECOND = 1e6;

  private final List<TestCase> cases;
  private final Map<Integer, TestCase> byNumber = new HashMap<>();
  private final Map<Integer, CaseResult> results = new HashMap<>();
  private final @Nullable Timing timing;
  private final Function<CaseRecord, CaseResult> judge;
  private final Suspicions suspicions;
  private final long maxBytes;
  private long bytes;
  private long suspiciousBytes;
  private String full = "";
  private boolean ready;
  private boolean called;
  private double elapsedUs = Double.POSITIVE_INFINITY;
  private int next;

  /** The steps of the current case that have ended. */
  private final List<StepRecord> steps = new ArrayList<>();

  /**
   * Creates a progress without results.
   *
   * @param timing how often calls are repeated; null for never
   * @param judge gives the result of each recorded case
   */
  CaseProgress(
      TestSuite suite,
      @Nullable Timing timing,
      Function<CaseRecord, CaseResult> judge,
      OutputSink sink) {
    this.cases = suite.cases();
    this.timing = timing;
    this.judge = judge;
    this.suspicions = new Suspicions(sink);
    long ofCalls = timing == null ? 0 : MAX_BYTES_OF_CALL * timing.repeat();
    long steps = cases.stream().mapToLong(c -> c.steps().size()).sum();
    this.maxBytes =
        MAX_BYTES + (MAX_BYTES_OF_CASE + ofCalls) * cases.size() + MAX_BYTES_OF_CASE * steps;
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
    called = false;
    steps.clear();
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
    if (isComplete()) {
      return;
    }
    String message =
        "the result is longer than "
            + (ResultsChannel.MAX_LINE >> 20)
            + " MiB; reduce the size of the outputs";
    TestCase testCase = current();
    if (steps.size() < testCase.steps().size()) {
      // The process continues with the next step.
      steps.add(currentStepFailed(message));
    } else {
      currentFailed(message);
    }
  }

  /** A line of the driver, which a component in the same process may have changed. */
  @Override
  public void content(String line) {
    ready = true;
    if (CaseRecordLine.isStep(line)) {
      step(line);
      return;
    }
    CaseRecord record;
    try {
      record = CaseRecordLine.read(line, timing);
    } catch (InvalidInputException e) {
      suspicious("a numbered line is not a case_record: " + e.getMessage(), line.length());
      return;
    }
    TestCase testCase = byNumber.get(record.no());
    if (testCase == null) {
      suspicious("a result of a case that is not in the suite", line.length());
    } else if (results.containsKey(record.no())) {
      suspicious("a second result of a case", line.length());
    } else {
      if (testCase != current()) {
        suspicions.add("results arrived in another order than the cases of the suite");
      }
      count(line);
      List<StepRecord> ended = testCase == current() ? List.copyOf(steps) : List.of();
      steps.clear();
      accept(withFirstCall(checked(record)).with(ended));
    }
  }

  private void count(String line) {
    bytes += line.length();
    if (bytes > maxBytes) {
      full = "the results exceed " + (maxBytes >> 20) + " MiB";
    }
  }

  /** The steps of a case arrive in their order, before the record of the case. */
  private void step(String line) {
    StepRecord record;
    try {
      record = CaseRecordLine.readStep(line);
    } catch (InvalidInputException e) {
      suspicious("a numbered line is not a step_record: " + e.getMessage(), line.length());
      return;
    }
    List<TestStep> expected = isComplete() ? List.of() : current().steps();
    int next = steps.size();
    if (isComplete()
        || record.record().no() != current().no()
        || next >= expected.size()
        || record.number() != next + 1
        || !record.name().equals(expected.get(next).name())) {
      suspicious("a result of a step that is not the next one of the case", line.length());
      return;
    }
    count(line);
    steps.add(record.with(withFirstCall(checked(record.record()))));
  }

  /** Marks the first call of the process, which also loads and compiles code. */
  private CaseRecord withFirstCall(CaseRecord record) {
    if (called || record.time() == null) {
      return record;
    }
    called = true;
    return record.ofFirstCall();
  }

  /** The record without processing times if one is impossible. */
  private CaseRecord checked(CaseRecord record) {
    CaseResult.ProcessingTime time = record.time();
    RepeatedCalls repeated = record.repeated();
    if ((time == null || isPossible(time)) && (repeated == null || isPossible(repeated))) {
      return record;
    }
    suspicions.add(
        "a result has a processing time that is negative or exceeds the run time of its process ("
            + Math.round(elapsedUs / US_IN_SECOND)
            + " s)");
    return record.withoutTime();
  }

  private boolean isPossible(CaseResult.ProcessingTime time) {
    double all = time.total() + time.hardware() + time.stub();
    return time.total() >= 0
        && time.hardware() >= 0
        && time.stub() >= 0
        && all <= elapsedUs + CLOCK_TOLERANCE_US;
  }

  private boolean isPossible(RepeatedCalls repeated) {
    double all = repeated.samples().stream().mapToDouble(Double::doubleValue).sum();
    return all <= elapsedUs + CLOCK_TOLERANCE_US;
  }

  private StepRecord currentStepFailed(String message) {
    int number = steps.size() + 1;
    String name = current().steps().get(number - 1).name();
    return StepRecord.error(current().no(), number, name, message);
  }

  /**
   * Records an error for the current case, which the test application could not report. In a
   * sequence, it is an error of the step that runs.
   */
  void currentFailed(String message) {
    if (ready && steps.size() < current().steps().size()) {
      steps.add(currentStepFailed(message));
    }
    List<StepRecord> ended = List.copyOf(steps);
    steps.clear();
    accept(CaseRecord.error(current().no(), message).with(ended));
  }

  private void accept(CaseRecord record) {
    results.put(record.no(), judge.apply(record));
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
