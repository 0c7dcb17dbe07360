package org.sitaf.agent.analysis;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.QuietBuild;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.score.FaultExecutions;
import org.sitaf.core.score.FaultJudge;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.sequence.SequenceExecutions;
import org.sitaf.core.score.sequence.SequenceJudge;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Scores one model: one test application executes the suite and all further cases. */
public final class ScoredModel {
  private static final int MAX_BUDGET = 1_000;

  /** Limit for the simulation time of all further cases. */
  private static final double MAX_SIMULATED_SECONDS = 60;

  private static final int MIN_BUDGET = 50;

  /** Each pair of steps has a fault of its own. */
  private static final int MIN_BUDGET_OF_SEQUENCES = 500;

  private final Activity activity;
  private final TestModel model;
  private final TestSuite suite;
  private final Recorder recorder;

  /** Executes cases and hands over what is recorded. */
  @FunctionalInterface
  public interface Recorder {
    /**
     * Executes the cases of a suite, without repeated calls and relations.
     *
     * @param signals whether the observer receives the signals of the cases
     * @param observer receives the records and signals, in any thread
     * @throws InvalidInputException if the cases could not be executed
     */
    TestResult record(TestSuite cases, boolean signals, BuildListener observer)
        throws InterruptedException;
  }

  /** A model without relations and repeated calls, which {@code recorder} executes. */
  public ScoredModel(Activity activity, TestModel model, TestSuite suite, Recorder recorder) {
    this.activity = activity;
    this.model = model;
    this.suite = suite;
    this.recorder = recorder;
  }

  /**
   * The score.
   *
   * @param budget maximum number of further cases; null for the default
   */
  public SpecificationScore score(@Nullable Integer budget) throws InterruptedException {
    int further = budget == null ? defaultBudget() : budget;
    return suite.isOfSequences() ? ofSequences(further) : ofSingleCalls(further);
  }

  private SpecificationScore ofSingleCalls(int budget) throws InterruptedException {
    FaultExecutions executions =
        new FaultExecutions(model, suite, activity.world(), activity.recorded(), budget);
    TrajectoryConditions conditions = conditions();
    Recording recording = record(executions.cases(), conditions);
    return new FaultJudge(
            executions,
            expected(recording.result()),
            activity.recorded(),
            conditions,
            recording.records(),
            recording.traces())
        .score();
  }

  private SpecificationScore ofSequences(int budget) throws InterruptedException {
    SequenceExecutions executions =
        new SequenceExecutions(model, suite, activity.world(), activity.recorded(), budget);
    TrajectoryConditions conditions = conditions();
    Recording recording = record(executions.cases(), conditions);
    return new SequenceJudge(
            executions,
            suite,
            activity.recorded(),
            conditions,
            recording.records(),
            recording.traces())
        .score();
  }

  /** What a test application recorded, by case number. */
  private record Recording(
      TestResult result, Map<Integer, CaseRecord> records, Map<Integer, Trace> traces) {}

  private Recording record(TestSuite cases, TrajectoryConditions conditions)
      throws InterruptedException {
    Map<Integer, CaseRecord> records = new ConcurrentHashMap<>();
    Map<Integer, Trace> traces = new ConcurrentHashMap<>();
    TestResult result =
        recorder.record(
            cases,
            !conditions.isEmpty(),
            new QuietBuild() {
              @Override
              public void signals(int no, Trace trace) {
                traces.put(no, trace);
              }

              @Override
              public void caseRecorded(CaseRecord record) {
                records.put(record.no(), record);
              }
            });
    requireResults(result);
    return new Recording(result, records, traces);
  }

  private TrajectoryConditions conditions() {
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions conditions =
        TrajectoryConditions.compile(
            model,
            activity.world() == null ? List.of() : WorldSignals.of(activity.world()),
            activity.world() == null ? Map.of() : WorldSignals.lists(activity.world()),
            activity.profile().limits().caseSimulation().toNanos() / 1e9,
            diagnostics);
    diagnostics.throwIfErrors();
    return conditions;
  }

  private int defaultBudget() {
    double seconds = seconds(model.target()) + secondsOfSteps();
    if (seconds <= MAX_SIMULATED_SECONDS / MAX_BUDGET) {
      return MAX_BUDGET;
    }
    int least = suite.isOfSequences() ? MIN_BUDGET_OF_SEQUENCES : MIN_BUDGET;
    return Math.max(least, (int) (MAX_SIMULATED_SECONDS / seconds));
  }

  private static double seconds(Target target) {
    return (target.settle().toNanos() + target.runFor().toNanos()) / 1e9;
  }

  /** Simulation time of the steps of a case, on average. */
  private double secondsOfSteps() {
    Map<String, Double> ofCalls = new HashMap<>();
    SequenceSpec sequence = model.sequence();
    if (sequence != null) {
      sequence.calls().forEach(c -> ofCalls.put(c.name(), seconds(c.model().target())));
    }
    return suite.cases().stream()
        .mapToDouble(
            c -> c.steps().stream().mapToDouble(s -> ofCalls.getOrDefault(s.name(), 0.0)).sum())
        .average()
        .orElse(0);
  }

  private void requireResults(TestResult result) {
    Map<Integer, CaseResult> byNumber = new HashMap<>();
    result.cases().forEach(c -> byNumber.put(c.no(), c));
    boolean executed =
        suite.cases().stream()
            .map(c -> byNumber.get(c.no()))
            .anyMatch(c -> c != null && c.verdict() != Verdict.DONT);
    if (!executed) {
      throw InvalidInputException.of(model.name(), "no case was executed");
    }
    if (result.isSuspect()) {
      throw InvalidInputException.of(
          model.name(), "the records cannot be trusted: " + String.join("; ", result.suspicions()));
    }
  }

  /** The suite with the expected values of the result, which a reference may have computed. */
  private TestSuite expected(TestResult result) {
    Map<Integer, CaseResult> byNumber = new HashMap<>();
    result.cases().forEach(c -> byNumber.put(c.no(), c));
    return suite.withCases(
        suite.cases().stream()
            .map(
                c ->
                    new TestCase(
                        c.no(),
                        c.valid(),
                        c.values(),
                        byNumber.get(c.no()).expected().stream()
                            .map(e -> new ExpectedValue(e.output(), e.literal()))
                            .toList()))
            .toList());
  }
}
