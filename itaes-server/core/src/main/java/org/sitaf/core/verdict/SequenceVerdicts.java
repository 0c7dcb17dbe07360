package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.sequence.AbstractState;
import org.sitaf.core.suite.sequence.StepStates;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.StepResult.Kind;

/**
 * Judges sequences: each step as a call of its own model, then the model's own post-conditions over
 * all steps, and the trajectory conditions over the whole case. The first step that did not pass
 * decides.
 */
final class SequenceVerdicts {
  private final Map<String, CallVerdicts> calls = new HashMap<>();
  private final Map<String, TestModel> models = new HashMap<>();
  private final StepStates states;
  private final CallVerdicts whole;
  private final TrajectoryVerdicts trajectories;
  private final StepMaps maps;

  /**
   * Creates the judge of a model's sequences.
   *
   * @param whole judges the model's own post-conditions
   * @param seed seed of the suite
   */
  SequenceVerdicts(
      TestModel model,
      SequenceSpec sequence,
      CallRecord record,
      CallVerdicts whole,
      TrajectoryVerdicts trajectories,
      long seed) {
    for (SequenceCall call : sequence.calls()) {
      calls.put(call.name(), new CallVerdicts(call.model(), record, seed));
      models.put(call.name(), call.model());
    }
    this.states = new StepStates(model, seed);
    this.whole = whole;
    this.trajectories = trajectories;
    this.maps = new StepMaps(models);
  }

  /** Whether a call has post-conditions. */
  boolean havePostConditions() {
    return models.values().stream().anyMatch(m -> !m.postConditions().isEmpty());
  }

  /** The steps of a case that was not executed. */
  List<StepResult> notExecuted(TestCase testCase, String reason) {
    return testCase.steps().stream().map(s -> missing(s, false, reason)).toList();
  }

  /**
   * The result of a case.
   *
   * @param signals used if all steps were executed and the model has trajectory conditions
   */
  CaseResult judge(TestCase testCase, CaseRecord record, TraceSource signals) {
    List<StepResult> steps = steps(testCase, record);
    CaseResult result = result(testCase, record, steps);
    boolean executed =
        record.outcome() == Outcome.RETURNED
            && steps.stream()
                .allMatch(s -> s.verdict() == Verdict.PASS || s.verdict() == Verdict.FAIL);
    if (!executed) {
      return result;
    }
    CaseResult judged =
        whole.withPostConditions(
            result,
            () -> {
              Variables variables = whole.inputs(testCase, "");
              variables.put(SequenceSpec.STEPS, (Object) maps.of(testCase, record));
              variables.put(Variables.CALLS, (Object) whole.calls(result.calls()));
              return variables.map();
            });
    return trajectories.judge(judged, () -> whole.inputs(testCase, "").map(), signals);
  }

  private List<StepResult> steps(TestCase testCase, CaseRecord record) {
    List<StepResult> results = new ArrayList<>();
    Optional<AbstractState> state = Optional.of(states.initial());
    boolean failed = false;
    for (int i = 0; i < testCase.steps().size(); i++) {
      TestStep step = testCase.steps().get(i);
      if (i >= record.steps().size()) {
        results.add(missing(step, failed, whyMissing(testCase, record)));
      } else {
        StepRecord ended = record.steps().get(i);
        // Only a step that ended without an error updates the state.
        Optional<AbstractState> after =
            ended.record().outcome() == Outcome.RETURNED
                ? state.flatMap(before -> states.after(before, step))
                : state;
        results.add(judge(testCase, step, i, ended, state, after, failed));
        state = after;
      }
      failed |= results.get(i).verdict() != Verdict.PASS;
    }
    return results;
  }

  /** Why a step has no record: the case ended before. */
  private static String whyMissing(TestCase testCase, CaseRecord record) {
    int ended = record.steps().size();
    if (ended > 0) {
      return "not executed: the sequence ended at "
          + StepResult.label(ended, testCase.steps().get(ended - 1).name());
    }
    return record.outcome() == Outcome.ERROR
        ? "not executed: the case failed before its first step"
        : record.message();
  }

  private StepResult missing(TestStep step, boolean failed, String message) {
    return new StepResult(
        step.name(),
        step.valid() ? Kind.VALID : Kind.INVALID,
        Verdict.DONT,
        failed,
        inputs(step),
        step.expected().stream().map(e -> new NamedValue(e.output(), e.literal())).toList(),
        List.of(),
        null,
        null,
        message,
        null,
        null);
  }

  /** The inputs of a step by name. */
  private List<NamedValue> inputs(TestStep step) {
    TestModel model = models.get(step.name());
    return model == null
        ? List.of()
        : IntStream.range(0, Math.min(step.values().size(), model.inputs().size()))
            .mapToObj(i -> new NamedValue(model.inputs().get(i).name(), step.values().get(i)))
            .toList();
  }

  private Kind kind(TestStep step, Optional<AbstractState> before) {
    if (step.valid()) {
      return Kind.VALID;
    }
    return before.isPresent() && !states.isAllowed(before.get(), step)
        ? Kind.FORBIDDEN
        : Kind.INVALID;
  }

  private StepResult judge(
      TestCase testCase,
      TestStep step,
      int index,
      StepRecord ended,
      Optional<AbstractState> state,
      Optional<AbstractState> after,
      boolean failed) {
    CallVerdicts call = calls.get(step.name());
    Double at = ended.atNanos() < 0 ? null : ended.atNanos() / 1e9;
    String before = state.map(states::text).orElse(null);
    String then = after.map(states::text).orElse(null);
    if (call == null) {
      return new StepResult(
          step.name(),
          Kind.VALID,
          ofEvent(ended.record().outcome()),
          failed,
          List.of(),
          List.of(),
          List.of(),
          at,
          null,
          ended.record().message(),
          before,
          then);
    }
    Map<String, Object> surroundings = new HashMap<>(state.map(states::variables).orElse(Map.of()));
    surroundings.put(SequenceSpec.STEP, (long) index + 1);
    CaseResult result = call.judge(ofStep(testCase, step), ended.record(), surroundings).result();
    return new StepResult(
        step.name(),
        kind(step, state),
        result.verdict(),
        failed,
        inputs(step),
        result.expected(),
        result.actual(),
        at,
        result.time(),
        result.message(),
        before,
        then);
  }

  private static Verdict ofEvent(Outcome outcome) {
    return switch (outcome) {
      case RETURNED -> Verdict.PASS;
      case NOT_CALLED -> Verdict.DONT;
      case THREW, ERROR -> Verdict.ERROR;
    };
  }

  /** A step as a case of its call's own model. */
  private static TestCase ofStep(TestCase testCase, TestStep step) {
    return new TestCase(testCase.no(), step.valid(), step.values(), step.expected());
  }

  private static CaseResult result(TestCase testCase, CaseRecord record, List<StepResult> steps) {
    Verdict verdict = Verdict.PASS;
    String message = "";
    if (record.outcome() == Outcome.ERROR && record.steps().isEmpty()) {
      // For example, an exception in the constructor of the component.
      verdict = Verdict.ERROR;
      message = "before the first step: " + record.message();
    }
    for (int i = 0; i < steps.size() && verdict == Verdict.PASS; i++) {
      StepResult step = steps.get(i);
      if (step.verdict() != Verdict.PASS) {
        verdict = step.verdict();
        message = step.label(i + 1) + ": " + step.message();
      }
    }
    if (verdict == Verdict.PASS && record.outcome() != Outcome.RETURNED) {
      verdict = record.outcome() == Outcome.NOT_CALLED ? Verdict.DONT : Verdict.ERROR;
      message = "after the last step: " + record.message();
    }
    return new CaseResult(
            testCase.no(),
            verdict,
            testCase.values(),
            List.of(),
            List.of(),
            calls(record),
            time(record),
            message)
        .withSteps(steps);
  }

  /** The calls of required interfaces in all steps. */
  private static StubCalls calls(CaseRecord record) {
    List<StubCalls.Call> recorded = new ArrayList<>(record.calls().recorded());
    long leftOut = record.calls().leftOut();
    for (StepRecord step : record.steps()) {
      recorded.addAll(step.record().calls().recorded());
      leftOut += step.record().calls().leftOut();
    }
    return new StubCalls(recorded, leftOut);
  }

  /** The time of all calls. */
  private static CaseResult.@Nullable ProcessingTime time(CaseRecord record) {
    double total = 0;
    double hardware = 0;
    double stub = 0;
    boolean cold = false;
    boolean any = false;
    for (StepRecord step : record.steps()) {
      CaseResult.ProcessingTime time = step.record().time();
      if (time != null) {
        any = true;
        total += time.total();
        hardware += time.hardware();
        stub += time.stub();
        cold |= time.cold();
      }
    }
    return any ? new CaseResult.ProcessingTime(total, hardware, stub, cold) : null;
  }
}
