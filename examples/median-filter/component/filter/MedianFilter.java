package filter;

/** Finds the median of three readings without sorting. */
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
    double a = readings[size - 3];
    double b = readings[size - 2];
    double c = readings[size - 1];
    return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
  }
}
