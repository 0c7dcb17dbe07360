package org.sitaf.core.falsify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hipparchus.exception.MathIllegalArgumentException;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.CholeskyDecomposition;
import org.hipparchus.linear.RealVector;

/**
 * Estimates the margin between executed cases by a Gaussian process with a Matérn kernel (5/2),
 * after Rasmussen and Williams, Gaussian Processes for Machine Learning, chapters 2, 4.2 and 5.4: a
 * mean and a standard deviation, which grows with the distance from what was executed.
 */
final class MarginEstimate {
  /** Lengths over which margins are related, as shares of a range. */
  private static final double[] LENGTHS = {0.05, 0.1, 0.2, 0.4, 0.8};

  /** The variance of what the ranges do not explain, as a share of the variance of all margins. */
  private static final double NOISE = 1e-4;

  private final List<double[]> points;
  private final double length;
  private final double mean;
  private final double deviation;
  private final double[] standardised;
  private final CholeskyDecomposition factors;
  private final RealVector weights;

  private MarginEstimate(List<double[]> points, double[] margins, double length) {
    this.points = List.copyOf(points);
    this.length = length;
    mean = Arrays.stream(margins).average().orElse(0);
    double sum = Arrays.stream(margins).map(m -> (m - mean) * (m - mean)).sum();
    deviation = sum > 0 ? Math.sqrt(sum / margins.length) : 1;
    standardised = Arrays.stream(margins).map(m -> (m - mean) / deviation).toArray();
    factors = decomposed(covariances());
    weights = factors.getSolver().solve(new ArrayRealVector(standardised, false));
  }

  /**
   * The most likely estimate of a few lengths.
   *
   * @param points executed cases, with coordinates from 0 to 1; at least one
   * @param margins theirs, all finite
   */
  static MarginEstimate of(List<double[]> points, double[] margins) {
    MarginEstimate best = new MarginEstimate(points, margins, LENGTHS[0]);
    for (int i = 1; i < LENGTHS.length; i++) {
      MarginEstimate other = new MarginEstimate(points, margins, LENGTHS[i]);
      best = other.likelihood() > best.likelihood() ? other : best;
    }
    return best;
  }

  /** The same estimate with another case. */
  MarginEstimate with(double[] point, double margin) {
    List<double[]> more = new ArrayList<>(points);
    more.add(point);
    double[] margins = new double[more.size()];
    Arrays.setAll(
        margins, i -> i < standardised.length ? mean + deviation * standardised[i] : margin);
    return new MarginEstimate(more, margins, length);
  }

  private double[][] covariances() {
    int count = points.size();
    double[][] covariance = new double[count][count];
    for (int i = 0; i < count; i++) {
      for (int j = 0; j < i; j++) {
        covariance[i][j] = kernel(points.get(i), points.get(j));
        covariance[j][i] = covariance[i][j];
      }
      covariance[i][i] = 1 + NOISE;
    }
    return covariance;
  }

  /** Points that are almost equal need more noise before their covariance can be factorised. */
  private static CholeskyDecomposition decomposed(double[][] covariance) {
    for (double further = NOISE; ; further *= 10) {
      try {
        return new CholeskyDecomposition(new Array2DRowRealMatrix(covariance, true), 1e-9, 1e-12);
      } catch (MathIllegalArgumentException e) {
        for (int i = 0; i < covariance.length; i++) {
          covariance[i][i] += further;
        }
      }
    }
  }

  /** The logarithm of the likelihood of the margins, but for a constant. */
  private double likelihood() {
    double logDeterminant = 0;
    for (int i = 0; i < points.size(); i++) {
      logDeterminant += 2 * Math.log(factors.getL().getEntry(i, i));
    }
    return -weights.dotProduct(new ArrayRealVector(standardised, false)) / 2 - logDeterminant / 2;
  }

  private double kernel(double[] one, double[] other) {
    double square = 0;
    for (int d = 0; d < one.length; d++) {
      square += (one[d] - other[d]) * (one[d] - other[d]);
    }
    double ratio = Math.sqrt(5 * square) / length;
    return (1 + ratio + ratio * ratio / 3) * Math.exp(-ratio);
  }

  /**
   * A low but plausible margin at a point.
   *
   * @param deviations how many standard deviations it is below the mean
   */
  double low(double[] point, double deviations) {
    double[] near = new double[points.size()];
    Arrays.setAll(near, i -> kernel(point, points.get(i)));
    RealVector covariance = new ArrayRealVector(near, false);
    double estimated = covariance.dotProduct(weights);
    if (deviations > 0) {
      double explained = covariance.dotProduct(factors.getSolver().solve(covariance));
      estimated -= deviations * Math.sqrt(Math.max(0, 1 - explained));
    }
    return mean + deviation * estimated;
  }
}
