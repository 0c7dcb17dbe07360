package org.sitaf.core.trajectory;

/**
 * The maximum or minimum over a window that moves with each sample, in constant time per sample: a
 * monotonic queue (Lemire, Streaming maximum-minimum filter, 2006).
 */
final class SlidingWindow {
  private SlidingWindow() {}

  /**
   * For each sample k, the maximum over the samples from {@code k + first} to {@code k + last}.
   *
   * @param values one per sample, without NaN
   * @param empty the result of a window without samples
   * @param beyond the value of each sample after the last one; those before the first one do not
   *     count
   */
  static double[] maximum(double[] values, int first, int last, double empty, double beyond) {
    int count = values.length;
    double[] result = new double[count];
    int[] queue = new int[count];
    int head = 0;
    int tail = 0;
    int next = Math.max(0, first);
    for (int k = 0; k < count; k++) {
      int end = Math.min(count - 1, k + last);
      for (; next <= end; next++) {
        while (tail > head && values[queue[tail - 1]] <= values[next]) {
          tail--;
        }
        queue[tail++] = next;
      }
      while (head < tail && queue[head] < k + first) {
        head++;
      }
      double maximum = head < tail ? values[queue[head]] : empty;
      result[k] = k + last >= count && first <= last ? Math.max(maximum, beyond) : maximum;
    }
    return result;
  }

  /** As {@link #maximum}, for the minimum. Changes the values. */
  static double[] minimum(double[] values, int first, int last, double empty, double beyond) {
    negate(values);
    double[] result = maximum(values, first, last, -empty, -beyond);
    negate(result);
    return result;
  }

  /** Changes the sign of each value. */
  static void negate(double[] values) {
    for (int k = 0; k < values.length; k++) {
      values[k] = -values[k];
    }
  }
}
