package org.sitaf.core.description.fault;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The name of a fault as a parameter of the simulation: {@code fault.DEVICE[.FIELD].KIND}, and of
 * its parts: {@code .at}, {@code .for} and {@code .value}.
 *
 * @param field a number in the reading or the command, or the beginning of several; empty for the
 *     whole device
 */
public record FaultName(String device, String field, FaultKind kind, Part part) {
  /** What all names begin with. */
  public static final String PREFIX = "fault.";

  /** When a fault ends, which expressions can use. */
  public static final String END = ".end";

  /** What a name sets. */
  public enum Part {
    /** The fault itself. */
    FAULT(""),
    /** When it begins, in seconds after the call. */
    AT(".at"),
    /** How long it lasts, in seconds. */
    FOR(".for"),
    /** The reading out of range. */
    VALUE(".value");

    private final String suffix;

    Part(String suffix) {
      this.suffix = suffix;
    }

    /** The end of the name. */
    public String suffix() {
      return suffix;
    }
  }

  public FaultName {
    Objects.requireNonNull(device);
    Objects.requireNonNull(field);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(part);
  }

  /** Whether a name is meant to be that of a fault. */
  public static boolean isFault(String name) {
    return name.startsWith(PREFIX);
  }

  /**
   * Parses a name.
   *
   * @throws IllegalArgumentException if it is not the name of a fault
   */
  public static FaultName parse(String name) {
    return find(name)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "must be named fault.DEVICE[.FIELD].KIND, optionally followed by .at, .for, or"
                        + " .value of out_of_range; kinds: "
                        + Arrays.stream(FaultKind.values())
                            .map(FaultKind::text)
                            .collect(Collectors.joining(", "))));
  }

  /** Parses a name; empty if it is not the name of a fault. */
  public static Optional<FaultName> find(String name) {
    if (!isFault(name)) {
      return Optional.empty();
    }
    Part part =
        Arrays.stream(Part.values())
            .filter(p -> p != Part.FAULT && name.endsWith(p.suffix()))
            .findFirst()
            .orElse(Part.FAULT);
    String fault = name.substring(PREFIX.length(), name.length() - part.suffix().length());
    List<String> steps = List.of(fault.split("\\.", -1));
    int last = steps.size() - 1;
    if (last < 1 || steps.stream().anyMatch(String::isEmpty)) {
      return Optional.empty();
    }
    return FaultKind.named(steps.get(last))
        .filter(kind -> part != Part.VALUE || kind == FaultKind.OUT_OF_RANGE)
        .map(
            kind ->
                new FaultName(steps.get(0), String.join(".", steps.subList(1, last)), kind, part));
  }

  /** The name of the fault itself. */
  public String fault() {
    return PREFIX + device + (field.isEmpty() ? "" : "." + field) + "." + kind.text();
  }

  /** The whole name. */
  public String text() {
    return fault() + part.suffix();
  }
}
