package filter;

import java.util.Arrays;

/** Finds the median of three readings by sorting them. */
public class MedianFilter {
  /** There is nothing to filter. */
  public static class NoReadings extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }

  public double Median(double[] readings) {
    int size = readings.length;
    if (size == 0) {
      throw new NoReadings();
    }
    if (size < 3) {
      return (readings[0] + readings[size - 1]) / 2;
    }
    return Arrays.stream(readings).skip(size - 3).boxed().sorted().skip(1).findFirst().orElseThrow();
  }
}
