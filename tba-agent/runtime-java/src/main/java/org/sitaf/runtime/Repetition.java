package org.sitaf.runtime;

import java.time.Duration;

/**
 * How the call of each case is repeated to measure its time.
 *
 * @param warmUp repeated calls before the measured ones
 * @param repeat measured calls
 * @param within no further call begins when this time has passed since the case began
 */
record Repetition(int warmUp, int repeat, Duration within) {
  /** More calls of either kind are never made. */
  static final int MAX_CALLS = 10_000;
}
