package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.SpecificationScore.Count;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.score.sequence.SequenceRecords.Recorded;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;
import org.sitaf.core.verdict.Verdict;

/** Judges a suite of sequences with each fault in turn, by the same rules as every test result. */
public final class SequenceJudge {
  private final SequenceExecutions executions;
  private final TestModel model;
  private final TestSuite suite;
  private final SequenceRecords records;
  private final ResultAssembler assembler;
  private final Map<Integer, CaseResult> baseline = new HashMap<>();

  /**
   * Creates a judge.
   *
   * @param recorded the interfaces whose calls the test application recorded
   * @param conditions the compiled trajectory conditions of the model
   * @param records of the executed cases, by number
   * @param traces of the executed cases if the model has trajectory conditions
   */
  public SequenceJudge(
      SequenceExecutions executions,
      TestSuite suite,
      List<InterfaceDescription> recorded,
      TrajectoryConditions conditions,
      Map<Integer, CaseRecord> records,
      Map<Integer, Trace> traces) {
    this.executions = executions;
    this.model = executions.model();
    this.suite = suite;
    this.records = new SequenceRecords(executions, records, traces);
    this.assembler = new ResultAssembler(model, suite, recorded, conditions, List.of());
    for (TestCase testCase : suite.cases()) {
      this.records.of(testCase).ifPresent(r -> baseline.put(testCase.no(), judge(r)));
    }
  }

  /** The results of the suite without faults, by case number. */
  public Map<Integer, CaseResult> baseline() {
    return Map.copyOf(baseline);
  }

  /** The score of the suite. */
  public SpecificationScore score() {
    int noticed = 0;
    int equivalent = 0;
    List<Survivor> survivors = new ArrayList<>();
    Map<String, Count> byOutput = outputs();
    Map<String, Boolean> hasEffect = new LinkedHashMap<>();
    for (SequenceFault fault : executions.faults()) {
      List<ChangedCase> changes = changes(fault, suite.cases());
      boolean isNoticed = changes.stream().anyMatch(this::isNoticed);
      boolean isReached = !changes.isEmpty();
      if (!isReached) {
        changes = changes(fault, executions.probes());
      }
      if (fault instanceof SequenceFault.OfSteps) {
        hasEffect.merge(fault.where(), !changes.isEmpty(), Boolean::logicalOr);
      }
      if (changes.isEmpty()) {
        equivalent++;
        continue;
      }
      count(changes, isNoticed, byOutput);
      if (isNoticed) {
        noticed++;
      } else {
        String suggestion =
            isReached
                ? SequenceSuggestions.of(model, fault, changes)
                : SequenceSuggestions.unreached(changes.get(0), executions.isIncomplete(fault));
        survivors.add(new Survivor(fault.text(), fault.where(), suggestion));
      }
    }
    return new SpecificationScore(
        executions.faults().size(),
        noticed,
        equivalent,
        survivors,
        byOutput,
        SequenceWeaknesses.of(model, suite, baseline, hasEffect, executions.notExecuted()));
  }

  private Map<String, Count> outputs() {
    Map<String, Count> outputs = new LinkedHashMap<>();
    for (SequenceCall call : Objects.requireNonNull(model.sequence()).calls()) {
      for (OutputElement output : call.model().outputs()) {
        if (!output.type().isVoid()) {
          outputs.put(call.name() + "." + output.name(), new Count(0, 0));
        }
      }
    }
    return outputs;
  }

  /** The cases that a fault changes. */
  private List<ChangedCase> changes(SequenceFault fault, List<TestCase> cases) {
    List<ChangedCase> changes = new ArrayList<>();
    for (TestCase testCase : cases) {
      Optional<Recorded> without = records.of(testCase);
      Optional<Recorded> with = without.flatMap(r -> records.of(fault, testCase));
      if (with.isPresent()) {
        CaseResult result = baseline.get(testCase.no());
        boolean passes = result != null && result.verdict() == Verdict.PASS;
        changes.add(new ChangedCase(testCase, without.get(), with.get(), passes));
      }
    }
    return changes;
  }

  private boolean isNoticed(ChangedCase change) {
    return change.passes() && judge(change.with()).verdict() != Verdict.PASS;
  }

  /** Counts the outputs that differ in a step. */
  private static void count(
      List<ChangedCase> changes, boolean isNoticed, Map<String, Count> byOutput) {
    for (Map.Entry<String, Count> each : byOutput.entrySet()) {
      if (changes.stream().anyMatch(c -> changes(c, each.getKey()))) {
        each.setValue(each.getValue().plus(isNoticed));
      }
    }
  }

  private static boolean changes(ChangedCase change, String output) {
    List<StepRecord> without = change.without().record().steps();
    List<StepRecord> with = change.with().record().steps();
    for (int i = 0; i < Math.min(without.size(), with.size()); i++) {
      String prefix = without.get(i).name() + ".";
      if (output.startsWith(prefix)) {
        String name = output.substring(prefix.length());
        if (!value(without.get(i), name).equals(value(with.get(i), name))) {
          return true;
        }
      }
    }
    return false;
  }

  private static Optional<String> value(StepRecord step, String output) {
    return step.record().actual().stream()
        .filter(a -> a.output().equals(output))
        .map(NamedValue::literal)
        .findFirst();
  }

  private CaseResult judge(Recorded executed) {
    Trace trace = executed.trace();
    return assembler.judge(
        executed.record(),
        () -> {
          if (trace == null) {
            throw new MissingTraceException("no signals were recorded");
          }
          return trace;
        });
  }
}
