package org.sitaf.core.compare;

/** What differs between two versions. */
public enum DifferenceClass {
  /** The return value or an out-parameter. */
  VALUE,
  /** The exception, crash or timeout that ended the case, or its message. */
  ERROR,
  /** The calls of required interfaces, their arguments or their order. */
  CALLS,
  /** A command to the hardware. */
  COMMANDS,
  /** An observation of the world or an output data port after the call. */
  OBSERVED,
  /** A signal over time. */
  TRAJECTORY,
  /** The verdict, although nothing else differs. */
  VERDICT,
  /** Lines of an unchanged source that are no longer executed. */
  COVERAGE_LOST,
  /** The time of the call; never a difference. */
  SLOWER;

  /** The name in documents. */
  public String id() {
    return name().toLowerCase(java.util.Locale.ROOT);
  }

  /** Whether a case has at most one difference of this class, whatever its output is. */
  boolean isOnePerCase() {
    return switch (this) {
      case VALUE, OBSERVED, COVERAGE_LOST -> false;
      case ERROR, CALLS, COMMANDS, TRAJECTORY, VERDICT, SLOWER -> true;
    };
  }
}
