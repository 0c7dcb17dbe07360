package org.sitaf.core.falsify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hipparchus.random.RandomGenerator;
import org.hipparchus.util.MathArrays;

/**
 * Proposes points where the margin may be low, from what is known of others. Each point of a batch
 * assumes that the ones before had the estimated margin, so that a batch is spread out (Ginsbourger
 * et al., Kriging is well-suited to parallelize optimization, 2010).
 */
final class Proposals {
  /** Most cases that an estimate is made from, because its cost grows with their third power. */
  private static final int MOST_KNOWN = 300;

  /** Random points of which the best one is proposed. */
  private static final int ANYWHERE = 1000;

  /** Further ones near the lowest margin. */
  private static final int NEARBY = 200;

  /** Standard deviations of points near the lowest margin, as shares of the ranges. */
  private static final double[] SPREADS = {0.02, 0.1};

  /**
   * How far below its mean an estimate is considered, in turn: a sure proposal, a bold one. Another
   * one follows that is far from everything, because a few cases cannot tell how uncertain their
   * estimate is.
   */
  private static final double[] DEVIATIONS = {0.5, 1.5};

  /** The share of the largest margins that are all the same to the search. */
  private static final double HIGH = 0.2;

  private final int dimensions;
  private final List<double[]> points = new ArrayList<>();
  private final List<Double> margins = new ArrayList<>();

  Proposals(int dimensions) {
    this.dimensions = dimensions;
  }

  /**
   * Adds an executed case.
   *
   * @param margin finite
   */
  void add(double[] point, double margin) {
    points.add(point);
    margins.add(margin);
  }

  /** The next points; random ones if nothing is known. */
  List<double[]> next(int count, RandomGenerator random) {
    int[] used =
        IntStream.range(0, points.size())
            .boxed()
            .sorted((a, b) -> Double.compare(margins.get(a), margins.get(b)))
            .limit(MOST_KNOWN)
            .mapToInt(Integer::intValue)
            .toArray();
    List<double[]> known = new ArrayList<>(Arrays.stream(used).mapToObj(points::get).toList());
    double[] values = limited(Arrays.stream(used).mapToDouble(margins::get).toArray());
    List<double[]> proposed = new ArrayList<>();
    if (known.isEmpty()) {
      for (int i = 0; i < count; i++) {
        proposed.add(anywhere(random));
      }
      return proposed;
    }
    MarginEstimate estimate = MarginEstimate.of(known, values);
    while (proposed.size() < count) {
      int turn = proposed.size() % (DEVIATIONS.length + 1);
      double[] point =
          turn < DEVIATIONS.length
              ? lowest(estimate, known.get(0), DEVIATIONS[turn], random)
              : farthest(proposed, random);
      proposed.add(point);
      estimate = estimate.with(point, estimate.low(point, 0));
    }
    return proposed;
  }

  /**
   * Large margins, also those of cases that cannot be executed, would hide the small differences.
   */
  private static double[] limited(double[] ascending) {
    if (ascending.length == 0) {
      return ascending;
    }
    double high = ascending[(int) ((ascending.length - 1) * (1 - HIGH))];
    return Arrays.stream(ascending).map(value -> Math.min(value, high)).toArray();
  }

  private double[] lowest(
      MarginEstimate estimate, double[] center, double deviations, RandomGenerator random) {
    double[] best = anywhere(random);
    double lowest = estimate.low(best, deviations);
    for (int i = 1; i < ANYWHERE + NEARBY; i++) {
      double[] point =
          i < ANYWHERE ? anywhere(random) : nearby(center, SPREADS[i % SPREADS.length], random);
      double low = estimate.low(point, deviations);
      if (low < lowest) {
        lowest = low;
        best = point;
      }
    }
    return best;
  }

  /** A random point far from all that are known or proposed. */
  private double[] farthest(List<double[]> proposed, RandomGenerator random) {
    double[] best = anywhere(random);
    double largest = distance(best, proposed);
    for (int i = 1; i < ANYWHERE; i++) {
      double[] point = anywhere(random);
      double distance = distance(point, proposed);
      if (distance > largest) {
        largest = distance;
        best = point;
      }
    }
    return best;
  }

  private double distance(double[] point, List<double[]> proposed) {
    return Stream.concat(points.stream(), proposed.stream())
        .mapToDouble(other -> MathArrays.distance(point, other))
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }

  private double[] anywhere(RandomGenerator random) {
    double[] point = new double[dimensions];
    Arrays.setAll(point, d -> random.nextDouble());
    return point;
  }

  private double[] nearby(double[] center, double spread, RandomGenerator random) {
    double[] point = new double[dimensions];
    Arrays.setAll(point, d -> Math.max(0, Math.min(1, center[d] + spread * random.nextGaussian())));
    return point;
  }
}
