package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.score.fault.ValueChanges;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.StubCalls;

/** What is recorded of the cases with a fault. */
final class SequenceRecords {
  private final SequenceExecutions executions;
  private final Map<Integer, CaseRecord> records;
  private final Map<Integer, Trace> traces;

  /**
   * Creates the records.
   *
   * @param records of all executed cases, by number
   * @param traces of all executed cases if the model has trajectory conditions
   */
  SequenceRecords(
      SequenceExecutions executions, Map<Integer, CaseRecord> records, Map<Integer, Trace> traces) {
    this.executions = executions;
    this.records = records;
    this.traces = traces;
  }

  /**
   * One execution.
   *
   * @param trace null if the signals are not known
   */
  record Recorded(CaseRecord record, @Nullable Trace trace) {}

  /** The record of a case without a fault; empty if it was not executed. */
  Optional<Recorded> of(TestCase testCase) {
    return of(testCase.values(), testCase.steps())
        .map(r -> new Recorded(r.record().numbered(testCase.no()), r.trace()));
  }

  private Optional<Recorded> of(List<String> values, List<TestStep> steps) {
    int no = executions.number(values, steps);
    CaseRecord record = no == 0 ? null : records.get(no);
    return record == null || record.outcome() == Outcome.NOT_CALLED
        ? Optional.empty()
        : Optional.of(new Recorded(record, traces.get(no)));
  }

  /** The record of a case with a fault; empty where it has no effect or was not executed. */
  Optional<Recorded> of(SequenceFault fault, TestCase testCase) {
    Optional<Recorded> base = of(testCase);
    if (base.isEmpty()) {
      return Optional.empty();
    }
    Recorded without = base.get();
    if (fault instanceof SequenceFault.OfRecords ofRecords) {
      CaseRecord record = without.record();
      List<StepRecord> changed = ofRecords.change().apply(testCase, record.steps());
      return isChanged(record.steps(), changed)
          ? Optional.of(new Recorded(record.with(changed), without.trace()))
          : Optional.empty();
    }
    return ((SequenceFault.OfSteps) fault)
        .change()
        .apply(testCase, executions.before(testCase))
        .flatMap(delivery -> delivered(testCase, without, delivery))
        .filter(
            with ->
                with.record().outcome() != without.record().outcome()
                    || isChanged(without.record().steps(), with.record().steps())
                    || signalsDiffer(without.trace(), with.trace()));
  }

  private Optional<Recorded> delivered(TestCase testCase, Recorded without, Delivery delivery) {
    if (delivery.steps().isEmpty()) {
      // Nothing reaches the component.
      CaseRecord record = without.record();
      return Optional.of(
          new Recorded(record.with(answers(testCase, record, record, delivery)), without.trace()));
    }
    return of(delivery.values(), delivery.steps())
        .map(
            executed -> {
              CaseRecord record = executed.record().numbered(testCase.no());
              return new Recorded(
                  record.with(answers(testCase, without.record(), record, delivery)),
                  renumbered(executed.trace(), delivery));
            });
  }

  /** The steps as the driver sees them. */
  private List<StepRecord> answers(
      TestCase testCase, CaseRecord without, CaseRecord executed, Delivery delivery) {
    List<StepRecord> seen = new ArrayList<>();
    for (int i = 0; i < testCase.steps().size(); i++) {
      TestStep step = testCase.steps().get(i);
      int answer = delivery.answers().get(i);
      if (answer == Delivery.NONE) {
        long at = seen.isEmpty() ? 0 : seen.get(i - 1).atNanos();
        StepRecord original = i < without.steps().size() ? without.steps().get(i) : null;
        seen.add(new StepRecord(i + 1, step.name(), at, neverSet(testCase.no(), step, original)));
      } else if (answer < executed.steps().size()) {
        StepRecord ended = executed.steps().get(answer);
        seen.add(
            new StepRecord(
                i + 1, step.name(), ended.atNanos(), ended.record().numbered(testCase.no())));
      } else {
        break;
      }
    }
    return seen;
  }

  /** A call that returns although it never reached the component. */
  private CaseRecord neverSet(int no, TestStep step, @Nullable StepRecord original) {
    List<NamedValue> values = new ArrayList<>();
    TestModel model =
        Objects.requireNonNull(executions.model().sequence())
            .call(step.name())
            .map(SequenceCall::model)
            .orElse(null);
    if (original != null && original.record().outcome() == Outcome.RETURNED) {
      for (NamedValue value : original.record().actual()) {
        DataType type =
            model == null
                ? new DataType.Unknown("")
                : model
                    .output(value.output())
                    .map(OutputElement::type)
                    .orElse(new DataType.Unknown(""));
        values.add(new NamedValue(value.output(), ValueChanges.zero(type)));
      }
    } else if (model != null) {
      for (OutputElement output : model.outputs()) {
        if (!output.type().isVoid()) {
          values.add(new NamedValue(output.name(), ValueChanges.zero(output.type())));
        }
      }
    }
    return new CaseRecord(no, Outcome.RETURNED, "", values, StubCalls.NONE, null, "");
  }

  /** Whether a value differs; times and messages do not count. */
  private static boolean isChanged(List<StepRecord> ones, List<StepRecord> others) {
    if (ones.size() != others.size()) {
      return true;
    }
    for (int i = 0; i < ones.size(); i++) {
      if (differ(ones.get(i).record(), others.get(i).record())) {
        return true;
      }
    }
    return false;
  }

  /** Whether a value of a step differs. */
  static boolean differ(CaseRecord one, CaseRecord other) {
    return one.outcome() != other.outcome()
        || !one.thrown().equals(other.thrown())
        || !one.actual().equals(other.actual())
        || !one.calls().equals(other.calls());
  }

  /** The signal of the step's number with the numbers of the case. */
  private static @Nullable Trace renumbered(@Nullable Trace trace, Delivery delivery) {
    int column = trace == null ? -1 : trace.names().indexOf(SequenceSpec.STEP);
    if (trace == null || column < 0) {
      return trace;
    }
    double[] numbers = delivery.numbers();
    List<double[]> columns = new ArrayList<>(trace.columns());
    columns.set(
        column,
        Arrays.stream(columns.get(column))
            .map(n -> n >= 1 && n <= numbers.length ? numbers[(int) n - 1] : n)
            .toArray());
    return new Trace(trace.firstNanos(), trace.stepNanos(), trace.names(), columns);
  }

  /** Whether the simulation went another way, as long as both cases last. */
  private static boolean signalsDiffer(@Nullable Trace one, @Nullable Trace other) {
    if (one == null || other == null) {
      return one != other;
    }
    int count = Math.min(one.count(), other.count());
    for (int i = 0; i < one.columns().size(); i++) {
      boolean isStep = one.names().get(i).equals(SequenceSpec.STEP);
      if (!isStep
          && !Arrays.equals(one.columns().get(i), 0, count, other.columns().get(i), 0, count)) {
        return true;
      }
    }
    return false;
  }
}
