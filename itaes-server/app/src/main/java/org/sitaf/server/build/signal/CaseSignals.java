package org.sitaf.server.build.signal;

import io.swagger.v3.oas.annotations.media.ArraySchema;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;

/**
 * The signals of a case, as they are stored and sent to the portal. Untrusted until {@link
 * #check()}.
 */
@Schema(name = "CaseSignals", description = "the signals that the trajectory conditions use")
public record CaseSignals(
    @Schema(
            description =
                "number of simulation steps of the case; if there are fewer times, those with the"
                    + " minima and maxima of the signals remain")
        int samples,
    @Schema(description = "seconds after the call, ascending; the last one is the end of the case")
        List<Double> times,
    List<Signal> signals,
    @Schema(description = "where the trajectory conditions apply, in the order of the model")
        List<Condition> conditions) {
  /** Maximum number of times. */
  static final int MAX_TIMES = 20_000;

  /** Maximum number of values of all signals. */
  static final int MAX_VALUES = 200_000;

  private static final int MAX_SIGNALS = 200;
  private static final int MAX_CONDITIONS = 200;
  private static final int MAX_NAME = 300;
  private static final int MAX_UNIT = 20;

  /** More than any simulation time of a case. */
  private static final double MAX_SECONDS = 1e7;

  public CaseSignals {
    times = List.copyOf(times);
    signals = List.copyOf(signals);
    conditions = List.copyOf(conditions);
  }

  /** A quantity over time. */
  @Schema(name = "CaseSignal")
  public record Signal(
      String name,
      @Schema(description = "SI unit; empty if it is not known") String unit,
      @ArraySchema(
              arraySchema =
                  @Schema(description = "one per time; null for a value that is not finite"),
              schema = @Schema(types = {"number", "null"}))
          List<@Nullable Double> values) {
    public Signal {
      values = Collections.unmodifiableList(new ArrayList<>(values));
    }
  }

  /** Where a trajectory condition applies. */
  @Schema(name = "CaseCondition")
  public record Condition(
      String name,
      @Schema(
              description =
                  "begin of the interval of its outermost operators, seconds after the call")
          double from,
      @Schema(description = "end of that interval") double to,
      @Schema(description = "names of the signals that it uses") List<String> signals) {
    public Condition {
      signals = List.copyOf(signals);
    }
  }

  /**
   * Checks limits and consistency.
   *
   * @throws RequestException if the signals cannot be those of a case
   */
  void check() {
    require(
        !times.isEmpty() && times.size() <= MAX_TIMES, "signals.times_ns: must be 1 to 20,000.");
    require(samples >= times.size(), "signals.samples: must be at least the number of times.");
    for (int i = 0; i < times.size(); i++) {
      require(
          Math.abs(times.get(i)) <= MAX_SECONDS && (i == 0 || times.get(i - 1) < times.get(i)),
          "signals.times_ns: must ascend, and be at most 1e7 s.");
    }
    require(
        !signals.isEmpty()
            && signals.size() <= MAX_SIGNALS
            && (long) signals.size() * times.size() <= MAX_VALUES,
        "signals.signals: must be 1 to 200 with at most 200,000 values in total.");
    Set<String> names = new HashSet<>();
    for (Signal signal : signals) {
      requireText(signal.name(), "signals.signals.name");
      require(names.add(signal.name()), "signals.signals.name: must be unique.");
      require(
          signal.unit().length() <= MAX_UNIT && isPrintable(signal.unit()),
          "signals.signals.unit: must be at most 20 printable characters.");
      require(
          signal.values().size() == times.size(), "signals.signals.values: must be one per time.");
    }
    require(conditions.size() <= MAX_CONDITIONS, "signals.conditions: must be at most 200.");
    for (Condition condition : conditions) {
      requireText(condition.name(), "signals.conditions.name");
      require(
          Math.abs(condition.from()) <= MAX_SECONDS
              && Math.abs(condition.to()) <= MAX_SECONDS
              && condition.from() <= condition.to(),
          "signals.conditions: must not end before it begins, and be at most 1e7 s.");
      require(
          condition.signals().size() <= signals.size() && names.containsAll(condition.signals()),
          "signals.conditions.signals: must be names of signals.");
    }
  }

  private static void requireText(String text, String field) {
    require(
        !text.isEmpty() && text.length() <= MAX_NAME && isPrintable(text),
        field + ": must be 1 to 300 printable characters.");
  }

  private static boolean isPrintable(String text) {
    return text.codePoints().noneMatch(Character::isISOControl);
  }

  private static void require(boolean condition, String message) {
    if (!condition) {
      throw RequestException.malformed(message);
    }
  }
}
