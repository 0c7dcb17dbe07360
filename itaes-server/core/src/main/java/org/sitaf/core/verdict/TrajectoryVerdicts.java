package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.trajectory.TrajectoryOutcome;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;

/** Evaluates the trajectory conditions of a model after each case. */
final class TrajectoryVerdicts {
  private final TrajectoryConditions conditions;

  TrajectoryVerdicts(TrajectoryConditions conditions) {
    this.conditions = conditions;
  }

  /**
   * The result of a case with its trajectory conditions.
   *
   * @param surroundings gives the values of the inputs for CEL, if they are needed
   */
  CaseResult judge(
      CaseResult result, Supplier<Map<String, Object>> surroundings, TraceSource source) {
    if (conditions.isEmpty()) {
      return result;
    }
    Map<String, Object> inputs = surroundings.get();
    Trace trace;
    try {
      trace = source.trace();
    } catch (MissingTraceException e) {
      return result.withVerdict(
          Verdict.ERROR, "trajectory conditions cannot be evaluated: " + e.getMessage());
    }
    CaseResult judged = result;
    List<TrajectoryResult> results = new ArrayList<>();
    List<String> notes = new ArrayList<>();
    List<String> names = conditions.names();
    for (int i = 0; i < names.size(); i++) {
      try {
        TrajectoryOutcome outcome = conditions.evaluate(i, trace, inputs);
        Verdict verdict = outcome.holds() ? Verdict.PASS : Verdict.FAIL;
        results.add(
            new TrajectoryResult(
                outcome.name(), verdict, outcome.margin(), outcome.atNanos() / 1e9));
        if (!outcome.note().isEmpty()) {
          notes.add(outcome.note());
        }
        if (!outcome.holds()) {
          judged = judged.withVerdict(judged.verdict().worse(Verdict.FAIL), outcome.violation());
        }
      } catch (EvaluationException | IllegalArgumentException e) {
        results.add(new TrajectoryResult(names.get(i), Verdict.ERROR, null, null));
        judged =
            judged.withVerdict(
                Verdict.ERROR, names.get(i) + ": cannot be evaluated: " + e.getMessage());
      }
    }
    return (notes.isEmpty() ? judged : judged.withNotes(notes)).with(results);
  }
}
