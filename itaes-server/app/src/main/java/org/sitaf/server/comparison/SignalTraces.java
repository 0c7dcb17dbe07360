package org.sitaf.server.comparison;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.server.build.signal.CaseSignals;
import org.sitaf.server.build.signal.StoredSignals;

/** The signals of the cases that two builds stored. */
final class SignalTraces {
  private final StoredSignals stored;
  private final Map<Integer, String> ofBuild;

  /** Numbers of cases of which only some samples were stored. */
  private final Set<Integer> thinned = new TreeSet<>();

  SignalTraces(StoredSignals stored, String buildId) {
    this.stored = stored;
    this.ofBuild = stored.ofBuild(buildId);
  }

  /** The signals of a case; null if there are none in every step. */
  @Nullable Trace of(int no) {
    String sha256 = ofBuild.get(no);
    if (sha256 == null) {
      return null;
    }
    Trace trace = trace(stored.content(sha256));
    if (trace == null) {
      thinned.add(no);
    }
    return trace;
  }

  Set<Integer> thinned() {
    return thinned;
  }

  /** Null if samples were left out, or are not evenly spaced. */
  static @Nullable Trace trace(CaseSignals signals) {
    List<Double> times = signals.times();
    if (signals.samples() != times.size() || times.size() < 2) {
      return null;
    }
    long first = nanos(times.get(0));
    long step = nanos(times.get(1)) - first;
    for (int i = 1; i < times.size(); i++) {
      if (nanos(times.get(i)) != first + i * step) {
        return null;
      }
    }
    if (step <= 0 || first > 0) {
      return null;
    }
    List<double[]> columns = new ArrayList<>();
    for (CaseSignals.Signal signal : signals.signals()) {
      columns.add(signal.values().stream().mapToDouble(v -> v == null ? Double.NaN : v).toArray());
    }
    return new Trace(
        first, step, signals.signals().stream().map(CaseSignals.Signal::name).toList(), columns);
  }

  private static long nanos(double seconds) {
    return Math.round(seconds * 1e9);
  }
}
