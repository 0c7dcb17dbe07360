package org.sitaf.core.verdict;

import org.jspecify.annotations.Nullable;

/**
 * The summary of a result (paper, Fig. 17): {@code total = pass + fail + error + dont}.
 *
 * @param unjudged number of PASS cases without an expected value, a condition or a relation
 * @param byError number of PASS cases that ended with an exception, which says nothing about values
 * @param times of PASS and FAIL cases; null if there are none
 */
public record Summary(
    int total,
    int pass,
    int fail,
    int error,
    int dont,
    int unjudged,
    int byError,
    @Nullable Times times) {
  public Summary {
    if (total != pass + fail + error + dont) {
      throw new IllegalArgumentException(
          "total " + total + " is not " + pass + " + " + fail + " + " + error + " + " + dont);
    }
  }

  /**
   * Processing times in microseconds: the median of a case with repeated calls, else the time of
   * its call.
   *
   * @param standardDeviation of the sample; 0 for a single case
   * @param first the time of the first call of a process, which the other numbers leave out; null
   *     if they leave none out
   */
  public record Times(
      double min, double max, double average, double standardDeviation, @Nullable Double first) {
    /** Times of which none is left out. */
    public Times(double min, double max, double average, double standardDeviation) {
      this(min, max, average, standardDeviation, null);
    }
  }
}
