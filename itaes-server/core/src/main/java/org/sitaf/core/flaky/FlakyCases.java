package org.sitaf.core.flaky;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Finds the cases whose verdicts or values differ between equal runs, and says what makes them
 * differ: the simulator if its states diverge first; the machine if only the time differs, which
 * then exceeds a limit; the component otherwise.
 */
public final class FlakyCases {
  /**
   * A call that exceeds the time limit now and then is slow on a busy machine if it takes this
   * share of the limit otherwise. A faster one hangs.
   */
  private static final double SLOW_SHARE = 0.05;

  private static final int NANO_DIGITS = 9;

  private final double limitSeconds;
  private final Map<Integer, List<CaseDigest>> runs = new TreeMap<>();
  private final Map<Integer, SignalDigest> signals = new HashMap<>();
  private final Map<Integer, Verdict> earlier = new HashMap<>();

  /**
   * Begins without runs.
   *
   * @param limitSeconds time limit of a case
   */
  public FlakyCases(double limitSeconds) {
    this.limitSeconds = limitSeconds;
  }

  /**
   * Takes the verdicts of a result that exists. Its values are not compared: another machine may
   * have computed them.
   */
  public void addEarlier(TestResult result) {
    result.cases().stream()
        .filter(c -> c.verdict() != Verdict.DONT)
        .forEach(c -> earlier.put(c.no(), c.verdict()));
  }

  /** Adds the signals of a case of the current run; may be called from any thread. */
  public void signals(int no, Trace trace) {
    SignalDigest digest = SignalDigest.of(trace);
    synchronized (signals) {
      signals.put(no, digest);
    }
  }

  /** Ends the current run. */
  public void add(TestResult result) {
    synchronized (signals) {
      for (CaseResult each : result.cases()) {
        if (each.verdict() != Verdict.DONT) {
          runs.computeIfAbsent(each.no(), no -> new ArrayList<>())
              .add(CaseDigest.of(each, signals.get(each.no())));
        }
      }
      signals.clear();
    }
  }

  /** The cases that differ, in the order of their numbers. */
  public List<FlakyCase> find() {
    return runs.entrySet().stream()
        .map(e -> of(e.getKey(), e.getValue()))
        .flatMap(Optional::stream)
        .toList();
  }

  private Optional<FlakyCase> of(int no, List<CaseDigest> executions) {
    CaseDigest first = executions.get(0);
    Optional<CaseDigest> other = executions.stream().filter(e -> !e.isEqual(first)).findFirst();
    Verdict before = earlier.getOrDefault(no, first.verdict());
    List<Verdict> verdicts =
        Stream.concat(
                earlier.containsKey(no) ? Stream.of(before) : Stream.empty(),
                executions.stream().map(CaseDigest::verdict))
            .toList();
    if (other.isEmpty()) {
      return before == first.verdict()
          ? Optional.empty()
          : Optional.of(
              new FlakyCase(
                  no,
                  FlakyCause.UNKNOWN,
                  verdicts,
                  "only the build differs; the further runs are equal"));
    }
    List<CaseDigest> inTime = executions.stream().filter(e -> !e.outOfTime()).toList();
    boolean otherValues =
        !inTime.isEmpty() && inTime.stream().anyMatch(e -> !e.isEqual(inTime.get(0)));
    if (inTime.size() < executions.size() && !otherValues) {
      return Optional.of(ofTime(no, verdicts, inTime));
    }
    return Optional.of(
        otherValues ? diverging(no, verdicts, inTime) : diverging(no, verdicts, executions));
  }

  /** Some runs exceeded the time limit, and the others are equal. */
  private FlakyCase ofTime(int no, List<Verdict> verdicts, List<CaseDigest> inTime) {
    double longest = largest(inTime, CaseDigest::seconds);
    return new FlakyCase(
        no,
        FlakyCause.MACHINE,
        verdicts,
        String.format(
            Locale.ROOT,
            "only times differ: a call that takes %.3g s at most otherwise exceeds the limit of"
                + " %.3g s%s",
            longest,
            limitSeconds,
            longest < SLOW_SHARE * limitSeconds ? "; it may also hang now and then" : ""));
  }

  private static double largest(List<CaseDigest> runs, ToDoubleFunction<CaseDigest> of) {
    return runs.stream().mapToDouble(of).max().orElse(0);
  }

  private static FlakyCase diverging(int no, List<Verdict> verdicts, List<CaseDigest> runs) {
    CaseDigest first = runs.get(0);
    for (CaseDigest other : runs) {
      if (!other.isEqual(first)) {
        FlakyCase found = diverging(no, verdicts, first.signals(), other.signals());
        if (found.cause() == FlakyCause.SIMULATOR) {
          return found;
        }
      }
    }
    CaseDigest other = runs.stream().filter(r -> !r.isEqual(first)).findFirst().orElseThrow();
    return diverging(no, verdicts, first.signals(), other.signals());
  }

  private static FlakyCase diverging(
      int no, List<Verdict> verdicts, @Nullable SignalDigest one, @Nullable SignalDigest other) {
    if (one == null || other == null) {
      return new FlakyCase(
          no, FlakyCause.COMPONENT, verdicts, "its inputs are equal, and what it returns differs");
    }
    OptionalInt commands = one.otherCommands(other);
    OptionalInt states = one.otherStates(other);
    if (states.isPresent() && (commands.isEmpty() || states.getAsInt() < commands.getAsInt())) {
      return new FlakyCase(
          no,
          FlakyCause.SIMULATOR,
          verdicts,
          "its states differ from %s s on, with equal commands before; please report this"
              .formatted(shown(one.seconds(states.getAsInt()))));
    }
    return new FlakyCase(
        no,
        FlakyCause.COMPONENT,
        verdicts,
        commands.isEmpty()
            ? "its readings are equal, and what it returns differs"
            : "its readings are equal until it gives other commands at %s s"
                .formatted(shown(one.seconds(commands.getAsInt()))));
  }

  /** A time of the simulation in full nanoseconds, without trailing zeros. */
  private static String shown(double seconds) {
    return BigDecimal.valueOf(seconds)
        .setScale(NANO_DIGITS, RoundingMode.HALF_EVEN)
        .stripTrailingZeros()
        .toPlainString();
  }
}
