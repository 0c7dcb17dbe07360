package org.sitaf.core.model;

import java.math.BigDecimal;
import java.util.List;
import java.util.Objects;

/** How the values of a test element are generated. */
public sealed interface TestSpec {

  /** The name of the scheme in documents. */
  String scheme();

  /**
   * Equivalence class partitioning (Fig. 5).
   *
   * @param representatives number of values per class, at least 1
   * @param offset distance of a representative from the boundary of an open class, greater than 0
   */
  record EquivalencePartitioning(
      EquivalenceClass equivalenceClass, int representatives, BigDecimal offset)
      implements TestSpec {
    public EquivalencePartitioning {
      Objects.requireNonNull(equivalenceClass);
      requirePositive(representatives, "representatives");
      requirePositive(offset.signum(), "offset");
    }

    @Override
    public String scheme() {
      return "ECP";
    }
  }

  /**
   * Boundary value analysis (Figs. 6 and 7) of a class with one or two boundaries.
   *
   * @param offset distance from a boundary, greater than 0
   * @param special whether values that often break robot code are added
   */
  record BoundaryValues(EquivalenceClass equivalenceClass, BigDecimal offset, boolean special)
      implements TestSpec {
    public BoundaryValues {
      if (!(equivalenceClass instanceof EquivalenceClass.OneBoundary)
          && !(equivalenceClass instanceof EquivalenceClass.TwoBoundary)) {
        throw new IllegalArgumentException("BVA needs a class with one or two boundaries");
      }
      requirePositive(offset.signum(), "offset");
    }

    @Override
    public String scheme() {
      return "BVA";
    }
  }

  /** Random numbers from {@code min} to {@code max}, both inclusive. */
  record RandomNumbers(int count, BigDecimal min, BigDecimal max, Distribution distribution)
      implements TestSpec {
    public RandomNumbers {
      requirePositive(count, "count");
      Objects.requireNonNull(distribution);
      if (min.compareTo(max) > 0) {
        throw new IllegalArgumentException("min " + min + " is above max " + max);
      }
    }

    @Override
    public String scheme() {
      return "RANDOM";
    }
  }

  /**
   * Random strings with boundary lengths (Fig. 8).
   *
   * @param minLength in characters, not negative
   * @param maxLength in characters, inclusive
   * @param negativeCharacters characters that make a string invalid
   */
  record RandomStrings(
      int minLength,
      int maxLength,
      boolean alphabet,
      boolean number,
      boolean specialCharacters,
      boolean space,
      String negativeCharacters)
      implements TestSpec {
    private static final int MAX_NEGATIVE = 1_000;

    public RandomStrings {
      Objects.requireNonNull(negativeCharacters);
      if (minLength < 0 || minLength > maxLength) {
        throw new IllegalArgumentException(
            "lengths must be 0 <= min_length <= max_length, not " + minLength + ".." + maxLength);
      }
      if (negativeCharacters.length() > MAX_NEGATIVE) {
        throw new IllegalArgumentException(
            "negative_char_list has "
                + negativeCharacters.length()
                + " characters; at most "
                + MAX_NEGATIVE
                + " are allowed");
      }
    }

    @Override
    public String scheme() {
      return "RANDOM_STRING";
    }
  }

  /** How random numbers are distributed. */
  sealed interface Distribution {
    /** Uniform over the range. */
    record Uniform() implements Distribution {}

    /** Normal, truncated to the range. */
    record Normal(double mean, double standardDeviation) implements Distribution {
      public Normal {
        if (!(standardDeviation > 0)) {
          throw new IllegalArgumentException("standard_deviation must be greater than 0");
        }
      }
    }

    /** An operational profile: weighted ranges. */
    record Weighted(List<WeightedRange> ranges) implements Distribution {
      public Weighted {
        ranges = List.copyOf(ranges);
        if (ranges.isEmpty()) {
          throw new IllegalArgumentException("a weighted distribution needs at least one range");
        }
      }
    }
  }

  /** A range of an operational profile; min and max are inclusive. */
  record WeightedRange(BigDecimal min, BigDecimal max, double weight) {
    public WeightedRange {
      if (min.compareTo(max) > 0) {
        throw new IllegalArgumentException("min " + min + " is above max " + max);
      }
      if (!(weight > 0) || Double.isInfinite(weight)) {
        throw new IllegalArgumentException("a weight must be greater than 0 and finite");
      }
    }
  }

  private static void requirePositive(int number, String what) {
    if (number <= 0) {
      throw new IllegalArgumentException(what + " must be greater than 0");
    }
  }
}
