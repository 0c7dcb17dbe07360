package org.sitaf.core.timing;

/**
 * How often the call of each case is repeated to measure its time. The first call of a case decides
 * its verdict; {@code warmUp} further calls are not measured, then {@code repeat} calls are.
 *
 * @param warmUp from 0 to {@link #MAX_WARM_UP}
 * @param repeat from 1 to {@link #MAX_REPEAT}
 * @param line in its document; 0 if unknown
 */
public record Timing(int warmUp, int repeat, int line) {
  public static final int MAX_WARM_UP = 1000;
  public static final int MAX_REPEAT = 10_000;
  public static final int DEFAULT_WARM_UP = 3;
  public static final int DEFAULT_REPEAT = 20;

  public Timing {
    requireWithin("warm_up", warmUp, 0, MAX_WARM_UP);
    requireWithin("repeat", repeat, 1, MAX_REPEAT);
  }

  /** A timing that comes from no document. */
  public Timing(int warmUp, int repeat) {
    this(warmUp, repeat, 0);
  }

  private static void requireWithin(String name, int number, int min, int max) {
    if (number < min || number > max) {
      throw new IllegalArgumentException(
          "%s must be a whole number from %d to %d, not %d".formatted(name, min, max, number));
    }
  }
}
