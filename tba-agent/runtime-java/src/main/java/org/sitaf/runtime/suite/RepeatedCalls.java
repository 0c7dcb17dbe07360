package org.sitaf.runtime.suite;

import java.util.ArrayList;
import java.util.List;

/** The repeated calls of a case: the times of the measured ones, and whether any call differs. */
final class RepeatedCalls {
  private static final double NANOS_IN_MICRO = 1000;

  private final List<Long> nanos = new ArrayList<>();
  private String differs = "";

  /** Adds the time of a measured call in microseconds. */
  void add(double micros) {
    nanos.add(Math.round(micros * NANOS_IN_MICRO));
  }

  /** Sets how a call differs from the first one. */
  void differs(String text) {
    differs = text;
  }

  boolean differ() {
    return !differs.isEmpty();
  }

  /** The times of the measured calls in nanoseconds. */
  List<Long> nanos() {
    return nanos;
  }

  /** How a call differs from the first one; empty if none does. */
  String differs() {
    return differs;
  }
}
