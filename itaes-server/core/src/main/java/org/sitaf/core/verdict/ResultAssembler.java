package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.PostConditions;
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
  private final List<Expression> postConditions;
  private final CallRecord calls;
  private final Expectations expectations;
  private final TrajectoryVerdicts trajectories;
  private final RelationVerdicts relations;
  private final InputValidity validity;
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
    this.relations = new RelationVerdicts(model, secondRuns, this::expectsException);
    this.trajectories = new TrajectoryVerdicts(trajectories);
    this.calls = new CallRecord(required);
    this.model = Objects.requireNonNull(model);
    this.expectations = new Expectations(model);
    this.suite = Objects.requireNonNull(suite);
    this.validity = new InputValidity(model, suite.generation().seed());
    this.postConditions = PostConditions.of(model);
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
    result = record.notes().isEmpty() ? result : result.withNotes(record.notes());
    return repeated == null ? result : result.with(repeated);
  }

  private CaseResult judgeFirst(CaseRecord record, TraceSource signals) {
    TestCase testCase = cases.get(record.no());
    if (testCase == null) {
      throw new IllegalArgumentException("the suite has no case " + record.no());
    }
    CaseResult result = expectations.judge(testCase, record);
    boolean threw = record.outcome() == CaseRecord.Outcome.THREW;
    Optional<CaseResult> accepted =
        threw && result.verdict() == Verdict.ERROR
            ? accepted(testCase, record, result)
            : Optional.empty();
    boolean completed =
        record.outcome() == CaseRecord.Outcome.RETURNED
            || threw && (result.verdict() == Verdict.PASS || accepted.isPresent());
    Map<String, Object> inputs = completed ? inputs(testCase, record.thrown()).map() : Map.of();
    if (accepted.isPresent()) {
      result = accepted.get();
    } else if (completed) {
      result = trajectories.judge(withPostConditions(testCase, record, result), inputs, signals);
    }
    return relations.judge(testCase, record, result, completed, inputs);
  }

  /** Whether a case may throw the recorded exception. */
  private boolean expectsException(TestCase testCase, CaseRecord record) {
    CaseResult result = expectations.judge(testCase, record);
    return result.verdict() == Verdict.PASS || accepted(testCase, record, result).isPresent();
  }

  /**
   * Where no output has an expected value, post-conditions about {@code error} decide whether an
   * exception is right. If it is not, the case remains an ERROR.
   */
  private Optional<CaseResult> accepted(TestCase testCase, CaseRecord record, CaseResult result) {
    if (!testCase.expected().isEmpty()
        || postConditions.stream().noneMatch(c -> c.mentions(Variables.ERROR))
        || model.inputs().stream().anyMatch(i -> i.name().equals(Variables.ERROR))) {
      return Optional.empty();
    }
    CaseResult passed =
        new CaseResult(
            result.no(),
            Verdict.PASS,
            result.values(),
            List.of(),
            List.of(new NamedValue("", Value.ERROR_PREFIX + record.thrown())),
            result.calls(),
            record.time(),
            "");
    return Optional.of(withPostConditions(testCase, record, passed))
        .filter(judged -> judged.verdict() == Verdict.PASS);
  }

  private CaseResult withPostConditions(TestCase testCase, CaseRecord record, CaseResult result) {
    CaseResult judged = result;
    for (int i = 0; i < postConditions.size(); i++) {
      Expression condition = postConditions.get(i);
      Condition written = model.postConditions().get(i);
      String label = written.name().isEmpty() ? condition.text() : written.name();
      if (condition.mentions(Variables.CALLS) && result.calls().leftOut() > 0) {
        judged =
            judged.withVerdict(
                Verdict.ERROR,
                "post-condition cannot be evaluated: "
                    + label
                    + ": of "
                    + (result.calls().recorded().size() + result.calls().leftOut())
                    + " calls only the first "
                    + result.calls().recorded().size()
                    + " were recorded");
        continue;
      }
      try {
        Map<String, Object> variables = variables(testCase, record, result);
        if (!condition.isTrue(variables)) {
          String compared = condition.explain(variables);
          judged =
              judged.withVerdict(
                  judged.verdict().worse(Verdict.FAIL),
                  "post-condition violated: "
                      + label
                      + (compared.isEmpty() ? "" : ": " + compared));
        }
      } catch (EvaluationException | IllegalArgumentException e) {
        judged =
            judged.withVerdict(
                Verdict.ERROR,
                "post-condition cannot be evaluated: "
                    + label
                    + ": "
                    + e.getMessage()
                    + location(written));
      }
    }
    return judged;
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
            all, !model.postConditions().isEmpty() || !model.trajectoryConditions().isEmpty()),
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
    return new CaseResult(no, verdict, result.values(), result.expected(), List.of(), null, reason);
  }

  private static CaseResult notExecuted(TestCase testCase, String reason) {
    return new CaseResult(
        testCase.no(),
        Verdict.DONT,
        testCase.values(),
        testCase.expected().stream().map(e -> new NamedValue(e.output(), e.literal())).toList(),
        List.of(),
        null,
        reason);
  }

  /** File and line of a condition in parentheses; empty if unknown. */
  private String location(Condition condition) {
    int line = condition.line();
    return line == 0 ? "" : " (" + model.source() + ":" + line + ")";
  }

  private Variables inputs(TestCase testCase, String thrown) {
    Variables variables = new Variables();
    validity.put(variables, testCase);
    variables.put(Variables.ERROR, (Object) thrown);
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      variables.put(input.name(), testCase.values().get(i), input.type());
    }
    return variables;
  }

  private Map<String, Object> variables(TestCase testCase, CaseRecord record, CaseResult result) {
    Variables variables = inputs(testCase, record.thrown());
    for (NamedValue actual : result.actual()) {
      OutputElement output = model.output(actual.output()).orElse(null);
      if (output != null) {
        variables.put("actual_" + output.name(), actual.literal(), output.type());
        if (MemberPath.root(output.name()).equals(OutputElement.RETURN_NAME)) {
          String part = output.name().substring(OutputElement.RETURN_NAME.length());
          variables.put("actual" + part, actual.literal(), output.type());
        }
      } else if (actual.output().isEmpty() || actual.output().equals(OutputElement.RETURN_NAME)) {
        variables.put(
            "actual", (Object) Variables.plain(actual.literal(), new DataType.Unknown("")));
      }
    }
    variables.put(Variables.CALLS, (Object) calls.of(result.calls()));
    if (model.inputs().stream().noneMatch(i -> i.name().equals(Variables.MESSAGES))) {
      variables.put(Variables.MESSAGES, (Object) calls.messages(result.calls()));
    }
    return variables.map();
  }
}
