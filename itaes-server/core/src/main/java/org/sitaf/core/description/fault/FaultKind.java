package org.sitaf.core.description.fault;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What can be wrong with a device. */
public enum FaultKind {
  STUCK,
  DROPOUT,
  OFFSET,
  SCALE,
  NOISE,
  DELAY,
  INTERMITTENT,
  OUT_OF_RANGE,
  /** Commands have no effect. */
  IGNORED,
  /** Actuators are at their limit in the direction of the command. */
  SATURATED;

  /** The kind of a name in a test model. */
  static Optional<FaultKind> named(String name) {
    return Arrays.stream(values()).filter(k -> k.text().equals(name)).findFirst();
  }

  /** The name in a test model. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Whether it changes commands, not readings. */
  public boolean isOfCommands() {
    return this == IGNORED || this == SATURATED;
  }

  /** Whether its value is 0 or 1. */
  public boolean isSwitch() {
    return isOfCommands() || this == STUCK || this == DROPOUT || this == OUT_OF_RANGE;
  }

  /** Whether only numbers can have it, not truth values. */
  boolean isOfNumbers() {
    return this == OFFSET || this == SCALE || this == NOISE || this == OUT_OF_RANGE;
  }

  /** The value that means no fault. */
  public double neutral() {
    return this == SCALE ? 1 : 0;
  }
}
