package org.sitaf.runtime;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The command line of a test application.
 *
 * @param results a file, or {@code fd:N} for a descriptor that is already open
 * @param bridge gRPC target of the simulator; null when the component needs no simulation
 * @param world the world description; null when {@code bridge} is null
 * @param from the number of the first case to run; 0 for all
 * @param caseSimulation maximum simulation time of a case; null for no limit
 * @param repetition how the call of each case is repeated; null if it is not
 * @param recording folder for a recording of the motion in each case; null for none
 */
record CommandLine(
    Path suite,
    String results,
    @Nullable String bridge,
    @Nullable Path world,
    long seed,
    int from,
    @Nullable Path recording,
    @Nullable Duration caseSimulation,
    @Nullable Repetition repetition) {
  static final String USAGE =
      "--suite FILE --results FILE [--bridge TARGET --world FILE.world.yaml] [--seed N] [--from NO]"
          + " [--recording FOLDER] [--case-sim SECONDS] [--repeat N [--warm-up N] [--repeat-within"
          + " SECONDS]]";

  private static final Set<String> OPTIONS =
      Set.of(
          "--suite",
          "--results",
          "--bridge",
          "--world",
          "--seed",
          "--from",
          "--recording",
          "--case-sim",
          "--repeat",
          "--warm-up",
          "--repeat-within");
  private static final long DEFAULT_SEED = 1;
  private static final Duration MAX_TIME = Duration.ofDays(1000);

  /**
   * Reads the arguments.
   *
   * @throws CannotRunException when they are wrong
   */
  static CommandLine parse(String... arguments) {
    Map<String, String> given = new HashMap<>();
    for (int i = 0; i < arguments.length; i += 2) {
      if (!OPTIONS.contains(arguments[i]) || i + 1 == arguments.length) {
        throw usageError("'" + arguments[i] + "' is not an option with a value");
      }
      if (given.put(arguments[i], arguments[i + 1]) != null) {
        throw usageError(arguments[i] + " is given twice");
      }
    }
    if (given.containsKey("--bridge") != given.containsKey("--world")) {
      throw usageError("--bridge and --world belong together");
    }
    String world = given.get("--world");
    return new CommandLine(
        path(given, "--suite"),
        text(given, "--results"),
        given.get("--bridge"),
        world == null ? null : path(given, "--world"),
        number(given, "--seed", DEFAULT_SEED),
        Math.toIntExact(Math.min(number(given, "--from", 0), Integer.MAX_VALUE)),
        given.containsKey("--recording") ? path(given, "--recording") : null,
        given.containsKey("--case-sim") ? seconds("--case-sim", given.get("--case-sim")) : null,
        repetition(given));
  }

  private static @Nullable Repetition repetition(Map<String, String> given) {
    if (!given.containsKey("--repeat")) {
      if (given.containsKey("--warm-up") || given.containsKey("--repeat-within")) {
        throw usageError("--warm-up and --repeat-within need --repeat");
      }
      return null;
    }
    String within = given.get("--repeat-within");
    return new Repetition(
        Math.toIntExact(Math.min(number(given, "--warm-up", 0), Repetition.MAX_CALLS)),
        Math.toIntExact(Math.min(number(given, "--repeat", 0), Repetition.MAX_CALLS)),
        within == null ? MAX_TIME : seconds("--repeat-within", within));
  }

  private static String text(Map<String, String> given, String option) {
    String value = given.get(option);
    if (value == null) {
      throw usageError(option + " is missing");
    }
    return value;
  }

  private static Path path(Map<String, String> given, String option) {
    String value = text(given, option);
    try {
      return Path.of(value);
    } catch (InvalidPathException e) {
      throw new CannotRunException(option + ": '" + value + "' is not a path", e);
    }
  }

  private static long number(Map<String, String> given, String option, long defaultValue) {
    String value = given.get(option);
    if (value == null) {
      return defaultValue;
    }
    try {
      long number = Long.parseLong(value);
      if (number >= 0) {
        return number;
      }
    } catch (NumberFormatException e) {
      // Reported below, together with negative numbers.
    }
    throw usageError(option + ": '" + value + "' is not a whole number from 0");
  }

  private static Duration seconds(String option, String value) {
    try {
      double seconds = Double.parseDouble(value);
      if (seconds > 0 && seconds <= 1e9) {
        return Duration.ofNanos(Math.round(seconds * 1e9));
      }
    } catch (NumberFormatException e) {
      // Reported below, together with numbers that are not above 0.
    }
    throw usageError(option + ": '" + value + "' is not a number of seconds above 0");
  }

  private static CannotRunException usageError(String problem) {
    return new CannotRunException(problem + "; usage: " + USAGE);
  }
}
