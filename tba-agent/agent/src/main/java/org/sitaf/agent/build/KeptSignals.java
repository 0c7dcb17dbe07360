package org.sitaf.agent.build;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.RecordingOrder.Cases;
import org.sitaf.agent.executor.OutputSink;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TraceReduction;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TrajectoryResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Selects the signals of cases that are kept for a server, and reduces them. They come from the
 * simulator; the component cannot change them. Thread-safe.
 */
final class KeptSignals {
  /** Samples of a case. */
  private static final int MAX_SAMPLES = 10_000;

  /** Numbers of a case. */
  private static final int MAX_NUMBERS = 150_000;

  /** The reduction keeps some samples for each signal. */
  private static final int MAX_SIGNALS = 100;

  private static final double NANOS_PER_SECOND = 1e9;

  private final @Nullable Cases recorded;
  private final WorldDescription world;
  private final TrajectoryConditions conditions;
  private final BuildListener listener;

  private final KeptFiles kept;
  private int tooMany;

  /**
   * @param recorded which cases are recorded; null for none
   */
  KeptSignals(
      SignalLimits limits,
      @Nullable Cases recorded,
      WorldDescription world,
      TrajectoryConditions conditions,
      BuildListener listener) {
    this.kept = new KeptFiles("signals", limits.maxCases(), limits.maxBytes());
    this.recorded = recorded;
    this.world = world;
    this.conditions = conditions;
    this.listener = listener;
  }

  /** A case has finished; its signals are kept if it is selected and the limits permit it. */
  synchronized void add(CaseResult result, Trace trace) {
    List<String> names = conditions.plotted();
    if (names.isEmpty() || !selects(result)) {
      return;
    }
    if (names.size() > MAX_SIGNALS) {
      tooMany = names.size();
      return;
    }
    SignalExcerpt excerpt = excerpt(conditions.plotted(trace), result);
    if (kept.admit(excerpt.bytes())) {
      listener.signalsKept(result.no(), excerpt);
    }
  }

  private boolean selects(CaseResult result) {
    return recorded != null && recorded.include(result.verdict())
        || result.trajectories().stream().anyMatch(t -> t.verdict() != Verdict.PASS);
  }

  private SignalExcerpt excerpt(Trace trace, CaseResult result) {
    int width = trace.names().size();
    List<Long> decided =
        result.trajectories().stream()
            .map(TrajectoryResult::at)
            .filter(Objects::nonNull)
            .map(at -> Math.round(at * NANOS_PER_SECOND))
            .toList();
    int[] samples =
        TraceReduction.samples(trace, Math.min(MAX_SAMPLES, MAX_NUMBERS / width), decided);
    List<SignalExcerpt.Signal> signals = new ArrayList<>();
    for (int i = 0; i < width; i++) {
      String name = trace.names().get(i);
      double[] column = trace.columns().get(i);
      double[] values = Arrays.stream(samples).mapToDouble(k -> column[k]).toArray();
      signals.add(new SignalExcerpt.Signal(name, WorldSignals.unit(world, name), values));
    }
    return new SignalExcerpt(
        trace.count(),
        Arrays.stream(samples).mapToLong(trace::nanos).toArray(),
        signals,
        conditions.spans(trace));
  }

  /** Logs the totals. */
  synchronized void report(OutputSink log) {
    kept.totals().ifPresent(log::remark);
    if (tooMany > 0) {
      log.remark(
          "signals: none are kept, because the conditions use %d, and the limit is %d"
              .formatted(tooMany, MAX_SIGNALS));
    }
  }
}
