package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.trajectory.TrajectoryConditions;

/**
 * Creates the result of a build from the records of its test application: compares recorded values
 * with expected values, evaluates post-conditions, adds the cases without a record, and computes
 * the summary.
 */
public final class ResultAssembler {
  private final TestModel model;
  private final TestSuite suite;
  private final CallVerdicts call;
  private final TrajectoryVerdicts trajectories;
  private final RelationVerdicts relations;
  private final @Nullable SequenceVerdicts sequences;
  private final Map<Integer, TestCase> cases = new HashMap<>();

  /** Creates an assembler for a component that requires no interfaces. */
  public ResultAssembler(TestModel model, TestSuite suite) {
    this(model, suite, List.of());
  }

  /**
   * Creates an assembler.
   *
   * @param required the interfaces whose calls the test stub records
   */
  public ResultAssembler(TestModel model, TestSuite suite, List<InterfaceDescription> required) {
    this(model, suite, required, TrajectoryConditions.NONE);
  }

  /**
   * Creates an assembler for a model with trajectory conditions.
   *
   * @param required the interfaces whose calls the test stub records
   * @param trajectories the compiled trajectory conditions of the model
   */
  public ResultAssembler(
      TestModel model,
      TestSuite suite,
      List<InterfaceDescription> required,
      TrajectoryConditions trajectories) {
    this(model, suite, required, trajectories, List.of());
  }

  /**
   * Creates an assembler for a model with relations between two runs.
   *
   * @param required the interfaces whose calls the test stub records
   * @param trajectories the compiled trajectory conditions of the model
   * @param secondRuns one for each relation of the model, in its order; empty if there are none
   */
  public ResultAssembler(
      TestModel model,
      TestSuite suite,
      List<InterfaceDescription> required,
      TrajectoryConditions trajectories,
      List<ExecutedSecondRun> secondRuns) {
    this.model = Objects.requireNonNull(model);
    this.suite = Objects.requireNonNull(suite);
    CallRecord calls = new CallRecord(required);
    long seed = suite.generation().seed();
    this.call = new CallVerdicts(model, calls, seed);
    this.trajectories = new TrajectoryVerdicts(trajectories);
    this.relations = new RelationVerdicts(model, secondRuns, call::expectsException);
    this.sequences =
        model.sequence() == null
            ? null
            : new SequenceVerdicts(model, model.sequence(), calls, call, this.trajectories, seed);
    suite.cases().forEach(c -> cases.put(c.no(), c));
  }

  /**
   * The result of a recorded case whose signals are not known; see {@link #judge(CaseRecord,
   * TraceSource)}.
   *
   * @throws IllegalArgumentException if the suite has no such case
   */
  public CaseResult judge(CaseRecord record) {
    return judge(
        record,
        () -> {
          throw new TraceSource.MissingTraceException("no signals were recorded");
        });
  }

  /**
   * The result of a recorded case: its values compared with the expected ones, then its
   * post-conditions, trajectory conditions and relations evaluated. The worst verdict counts.
   *
   * @param signals used if the case completed and the model has trajectory conditions
   * @throws IllegalArgumentException if the suite has no such case
   */
  public CaseResult judge(CaseRecord record, TraceSource signals) {
    CaseResult result = judgeFirst(record, signals);
    RepeatedCalls repeated = record.repeated();
    if (!record.notes().isEmpty()) {
      List<String> notes = new ArrayList<>(record.notes());
      notes.addAll(result.notes());
      result = result.withNotes(notes);
    }
    return repeated == null ? result : result.with(repeated);
  }

  private CaseResult judgeFirst(CaseRecord record, TraceSource signals) {
    TestCase testCase = cases.get(record.no());
    if (testCase == null) {
      throw new IllegalArgumentException("the suite has no case " + record.no());
    }
    if (sequences != null) {
      return sequences.judge(testCase, record, signals);
    }
    CallVerdicts.Judged judged = call.judge(testCase, record, Map.of());
    CaseResult result =
        judged.completed() && !judged.accepted()
            ? trajectories.judge(judged.result(), judged.inputs(), signals)
            : judged.result();
    return relations.judge(testCase, record, result, judged.completed(), judged.inputs());
  }

  /**
   * The result of the build, with one result for each case of the suite in its order.
   *
   * @param results results of cases in any order; of several results of a case, the first is used
   * @param missing message of the cases without a result
   */
  public TestResult assemble(List<CaseResult> results, String missing, Provenance provenance) {
    Map<Integer, CaseResult> byNumber = new HashMap<>();
    results.forEach(r -> byNumber.putIfAbsent(r.no(), r));
    List<CaseResult> all = new ArrayList<>();
    for (TestCase testCase : suite.cases()) {
      CaseResult result = byNumber.get(testCase.no());
      all.add(result == null ? notExecuted(testCase, missing) : result);
    }
    return new TestResult(
        model.name(),
        provenance,
        Statistics.of(
            all,
            !model.postConditions().isEmpty()
                || !model.trajectoryConditions().isEmpty()
                || sequences != null && sequences.havePostConditions()),
        suite.parameters(),
        all,
        null);
  }

  /** The result of a case without a record. */
  public CaseResult without(int no, Verdict verdict, String reason) {
    TestCase testCase = cases.get(no);
    if (testCase == null) {
      throw new IllegalArgumentException("the suite has no case " + no);
    }
    CaseResult result = notExecuted(testCase, reason);
    return new CaseResult(no, verdict, result.values(), result.expected(), List.of(), null, reason)
        .withSteps(result.steps());
  }

  private CaseResult notExecuted(TestCase testCase, String reason) {
    return new CaseResult(
            testCase.no(),
            Verdict.DONT,
            testCase.values(),
            testCase.expected().stream().map(e -> new NamedValue(e.output(), e.literal())).toList(),
            List.of(),
            null,
            reason)
        .withSteps(sequences == null ? List.of() : sequences.notExecuted(testCase, reason));
  }
}
