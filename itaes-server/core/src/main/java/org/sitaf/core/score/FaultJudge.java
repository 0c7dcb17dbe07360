package org.sitaf.core.score;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.score.FaultyRecords.Recorded;
import org.sitaf.core.score.SpecificationScore.Count;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.score.fault.Fault;
import org.sitaf.core.score.fault.Row;
import org.sitaf.core.suite.SecondRun;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.ExecutedSecondRun;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;
import org.sitaf.core.verdict.Verdict;

/** Judges the suite with each fault in turn, by the same rules as every test result. */
public final class FaultJudge {
  private final FaultExecutions executions;
  private final TestModel model;
  private final TestSuite suite;
  private final List<InterfaceDescription> recorded;
  private final TrajectoryConditions conditions;
  private final FaultyRecords records;
  private final Map<Integer, CaseResult> baseline = new HashMap<>();
  private final ResultAssembler assembler;

  /**
   * Creates a judge.
   *
   * @param suite with the expected values
   * @param recorded the interfaces whose calls the test application recorded
   * @param conditions the compiled trajectory conditions of the model
   * @param records of the executed cases, by number
   * @param traces of the executed cases if the model has trajectory conditions
   */
  public FaultJudge(
      FaultExecutions executions,
      TestSuite suite,
      List<InterfaceDescription> recorded,
      TrajectoryConditions conditions,
      Map<Integer, CaseRecord> records,
      Map<Integer, Trace> traces) {
    this.executions = executions;
    this.model = executions.model();
    this.suite = suite;
    this.recorded = List.copyOf(recorded);
    this.conditions = conditions;
    this.records = new FaultyRecords(executions, records, traces);
    this.assembler = assembler(Optional.empty());
    for (TestCase testCase : suite.cases()) {
      this.records
          .of(testCase.values())
          .ifPresent(r -> baseline.put(testCase.no(), judge(assembler, testCase.no(), r)));
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
    Map<String, Count> byOutput = new LinkedHashMap<>();
    model.outputs().stream()
        .filter(o -> !o.type().isVoid())
        .forEach(o -> byOutput.put(o.name(), new Count(0, 0)));
    Map<String, Boolean> hasEffect = new LinkedHashMap<>();
    Suggestions suggestions = new Suggestions(model, suite);
    for (Fault fault : executions.faults()) {
      List<Effect> effects = effects(fault);
      boolean isNoticed = isNoticed(fault, effects);
      if (!isNoticed && effects.isEmpty()) {
        effects = probed(fault);
      }
      if (fault instanceof Fault.OfInputs) {
        hasEffect.merge(fault.where(), !effects.isEmpty(), Boolean::logicalOr);
      }
      if (effects.isEmpty()) {
        equivalent++;
        continue;
      }
      for (OutputElement output : model.outputs()) {
        if (effects.stream().anyMatch(e -> e.changes(output.name()))) {
          byOutput.computeIfPresent(output.name(), (name, count) -> count.plus(isNoticed));
        }
      }
      if (isNoticed) {
        noticed++;
      } else {
        survivors.add(new Survivor(fault.text(), fault.where(), suggestions.of(fault, effects)));
      }
    }
    return new SpecificationScore(
        executions.faults().size(),
        noticed,
        equivalent,
        survivors,
        byOutput,
        Weaknesses.of(model, suite, baseline, hasEffect));
  }

  /** The cases of the suite that a fault changes. */
  private List<Effect> effects(Fault fault) {
    List<Effect> effects = new ArrayList<>();
    for (int i = 0; i < suite.cases().size(); i++) {
      TestCase testCase = suite.cases().get(i);
      Row row = new Row(testCase.values(), i == 0 ? null : suite.cases().get(i - 1).values());
      Optional<Recorded> without = records.of(row.values());
      Optional<Recorded> with = records.of(fault, row);
      if (without.isPresent() && with.isPresent()) {
        effects.add(
            new Effect(
                testCase.no(),
                "case " + testCase.no(),
                testCase.values(),
                testCase.expected(),
                without.get().record(),
                with.get().record(),
                passes(testCase.no())));
      }
    }
    return effects;
  }

  /** What a fault changes outside of the suite. */
  private List<Effect> probed(Fault fault) {
    for (Row row : executions.probes()) {
      Optional<Recorded> without = records.of(row.values());
      Optional<Recorded> with = records.of(fault, row);
      if (without.isPresent() && with.isPresent()) {
        return List.of(
            new Effect(
                0,
                "",
                row.values(),
                List.of(),
                without.get().record(),
                with.get().record(),
                false));
      }
    }
    return List.of();
  }

  private boolean passes(int no) {
    CaseResult result = baseline.get(no);
    return result != null && result.verdict() == Verdict.PASS;
  }

  private boolean isNoticed(Fault fault, List<Effect> effects) {
    boolean relations = !executions.secondRuns().isEmpty();
    if (effects.isEmpty() && !relations) {
      return false;
    }
    ResultAssembler judging = relations ? assembler(Optional.of(fault)) : assembler;
    for (int i = 0; i < suite.cases().size(); i++) {
      TestCase testCase = suite.cases().get(i);
      if (!passes(testCase.no())) {
        continue;
      }
      Row row = new Row(testCase.values(), i == 0 ? null : suite.cases().get(i - 1).values());
      Optional<Recorded> with = records.of(fault, row);
      if (with.isEmpty() && relations) {
        with = records.of(row.values());
      }
      if (with.isPresent() && judge(judging, testCase.no(), with.get()).verdict() != Verdict.PASS) {
        return true;
      }
    }
    return false;
  }

  /** Judges with the second runs of relations, which have the fault, too. */
  private ResultAssembler assembler(Optional<Fault> fault) {
    List<ExecutedSecondRun> runs = new ArrayList<>();
    for (SecondRun run : executions.secondRuns()) {
      List<CaseRecord> executed = new ArrayList<>();
      for (TestCase testCase : run.suite().cases()) {
        Row row = new Row(testCase.values(), null);
        fault
            .flatMap(f -> records.of(f, row))
            .or(() -> records.of(row.values()))
            .ifPresent(r -> executed.add(r.record().numbered(testCase.no())));
      }
      runs.add(new ExecutedSecondRun(run, executed, "it was not executed"));
    }
    return new ResultAssembler(model, suite, recorded, conditions, runs);
  }

  private static CaseResult judge(ResultAssembler assembler, int no, Recorded executed) {
    Trace trace = executed.trace();
    return assembler.judge(
        executed.record().numbered(no),
        () -> {
          if (trace == null) {
            throw new MissingTraceException("no signals were recorded");
          }
          return trace;
        });
  }
}
