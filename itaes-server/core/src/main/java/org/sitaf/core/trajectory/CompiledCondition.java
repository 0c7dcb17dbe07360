package org.sitaf.core.trajectory;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.model.TrajectoryCondition;

/** A trajectory condition that can be evaluated over the traces of cases. */
final class CompiledCondition {
  /** The time relative to the call, in seconds. */
  static final String TIME = "t";

  private static final double NANOS_PER_SECOND = 1e9;
  private static final int BYTES_PER_NUMBER = Double.BYTES;

  /** Arrays per atom: truth values, margins, and copies during the evaluation. */
  private static final int ARRAYS_PER_ATOM = 4;

  private static final MathContext SHOWN = new MathContext(6);
  private static final int MAX_SHOWN = 5;

  private final TrajectoryCondition condition;
  private final Formula formula;
  private final List<CompiledAtom> atoms;

  CompiledCondition(TrajectoryCondition condition, Formula formula, List<CompiledAtom> atoms) {
    this.condition = condition;
    this.formula = formula;
    this.atoms = List.copyOf(atoms);
  }

  TrajectoryCondition condition() {
    return condition;
  }

  /** The names of the signals, without the time. */
  List<String> signals() {
    return atoms.stream()
        .flatMap(a -> a.signals().stream())
        .filter(name -> !name.equals(TIME))
        .distinct()
        .toList();
  }

  /** The signals that a plot shows, without the time. */
  List<String> plotted() {
    return atoms.stream()
        .flatMap(a -> a.plotted().stream())
        .filter(name -> !name.equals(TIME))
        .distinct()
        .toList();
  }

  /** Adds the signals that only a plot shows to columns by name. */
  void addPlotted(Map<String, double[]> columns, int count) {
    atoms.forEach(a -> a.lists().forEach(list -> list.addExtremes(columns, count)));
  }

  /** The memory for an evaluation. */
  long bytes(long samples) {
    return samples * BYTES_PER_NUMBER * (signals().size() + (long) ARRAYS_PER_ATOM * atoms.size());
  }

  /** Where the condition applies in a trace; an end after the trace is the end of the trace. */
  ConditionSpan span(Trace trace) {
    Interval span = formula.span();
    long begin = condition.fromSettle() ? trace.firstNanos() : 0;
    return new ConditionSpan(
        condition.name(),
        after(begin, span.from(), trace),
        after(begin, span.to(), trace),
        plotted());
  }

  private static long after(long begin, double seconds, Trace trace) {
    long last = trace.nanos(trace.count() - 1);
    return Math.max(begin, (long) Math.min(last, begin + seconds * NANOS_PER_SECOND));
  }

  TrajectoryOutcome evaluate(Trace whole, Map<String, Object> inputs) throws EvaluationException {
    Trace trace = condition.fromSettle() ? whole : whole.fromCall();
    Map<String, double[]> columns = new HashMap<>(trace.byName());
    double[] times = new double[trace.count()];
    for (int k = 0; k < times.length; k++) {
      times[k] = trace.seconds(k);
    }
    columns.put(TIME, times);
    List<AtomValues> values = new ArrayList<>();
    for (CompiledAtom atom : atoms) {
      values.add(atom.values(columns, inputs, trace.count()));
    }
    Evaluator evaluator = new Evaluator(values, trace.count(), trace.stepNanos());
    Robustness robustness = evaluator.evaluate(formula);
    String unsampled = unsampled(trace);
    String violation =
        robustness.holds()
            ? ""
            : unsampled.isEmpty()
                ? violation(trace, columns, robustness.sample(), evaluator.decidingAtom(formula))
                : unsampled;
    return new TrajectoryOutcome(
        condition.name(),
        robustness.holds(),
        robustness.margin(),
        trace.nanos(robustness.sample()),
        violation,
        robustness.holds() ? unsampled : "");
  }

  /** Says that the case ends before the interval of the condition begins; else empty. */
  private String unsampled(Trace trace) {
    double begin = formula.span().from();
    double end = trace.seconds(trace.count() - 1) - (condition.fromSettle() ? trace.seconds(0) : 0);
    return begin <= end
        ? ""
        : condition.name()
            + ": no sample lies in its interval, which begins at "
            + number(begin)
            + " s; the case ends at "
            + number(end)
            + " s";
  }

  private String violation(
      Trace trace, Map<String, double[]> columns, int sample, int decidingAtom) {
    TreeSet<String> shown =
        new TreeSet<>(decidingAtom < 0 ? plotted() : atoms.get(decidingAtom).plotted());
    addPlotted(columns, trace.count());
    String values =
        shown.stream()
            .limit(MAX_SHOWN)
            .map(name -> name + " is " + number(columns.get(name)[sample]))
            .collect(Collectors.joining(", "));
    return condition.name()
        + ": broken at "
        + BigDecimal.valueOf(trace.nanos(sample), 9).stripTrailingZeros().toPlainString()
        + " s"
        + (values.isEmpty() ? "" : ": " + values);
  }

  private static String number(double value) {
    if (Double.isNaN(value) || Double.isInfinite(value)) {
      return Double.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
    }
    BigDecimal rounded = new BigDecimal(value).round(SHOWN).stripTrailingZeros();
    boolean isLong = rounded.precision() - rounded.scale() > 15 || rounded.scale() > 15;
    return isLong ? rounded.toString() : rounded.toPlainString();
  }
}
