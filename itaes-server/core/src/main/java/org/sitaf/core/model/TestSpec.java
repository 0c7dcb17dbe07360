package org.sitaf.core.model;

import java.math.BigDecimal;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** How the values of a test element are generated. */
public sealed interface TestSpec {

  /** The name of the scheme in documents. */
  String scheme();

  /** Whether values that often break robot code are added. */
  enum Special {
    /** None are added. */
    NONE,
    /** They are combined like all other values. */
    COMBINED,
    /** Each has one case instead of all tuples. */
    EACH
  }

  /** Special values of this specification. */
  default Special special() {
    return Special.NONE;
  }

  /**
   * Equivalence class partitioning (Fig. 5).
   *
   * @param representatives number of values per class, at least 1
   * @param offset distance of a representative from the boundary of an open class, greater than 0
   */
  record EquivalencePartitioning(
      EquivalenceClass equivalenceClass, int representatives, BigDecimal offset, Special special)
      implements TestSpec {
    public EquivalencePartitioning {
      Objects.requireNonNull(special);
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
   * @param equivalenceClass null if there are only special values
   * @param offset distance from a boundary, greater than 0
   */
  record BoundaryValues(
      @Nullable EquivalenceClass equivalenceClass, BigDecimal offset, Special special)
      implements TestSpec {
    public BoundaryValues {
      Objects.requireNonNull(special);
      if (equivalenceClass == null) {
        if (special == Special.NONE) {
          throw new IllegalArgumentException(
              "BVA needs an equiv_class, special=\"true\" or special=\"each\"");
        }
      } else if (!(equivalenceClass instanceof EquivalenceClass.OneBoundary)
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
  record RandomNumbers(
      int count, BigDecimal min, BigDecimal max, Distribution distribution, Special special)
      implements TestSpec {
    public RandomNumbers {
      Objects.requireNonNull(special);
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

  /**
   * Whole rotations: turns about axes and diagonals, turns next to singularities, then random ones.
   *
   * @param form how they are written; null if the names of a struct's members decide
   */
  record Rotations(@Nullable RotationForm form, int count) implements TestSpec {
    public Rotations {
      requirePositive(count, "count");
    }

    @Override
    public String scheme() {
      return "ROTATION";
    }
  }

  /**
   * Whole directions: axes, diagonals, axes turned a little, then random ones.
   *
   * @param length of each, greater than 0
   */
  record Directions(int count, double length) implements TestSpec {
    public Directions {
      requirePositive(count, "count");
      if (!(length > 0) || Double.isInfinite(length)) {
        throw new IllegalArgumentException("length must be greater than 0 and finite");
      }
    }

    @Override
    public String scheme() {
      return "DIRECTION";
    }
  }

  /**
   * Whole poses: positions at the corners, in the middle and random, each with a rotation.
   *
   * @param form how orientations are written; null if the names of a struct's members decide
   * @param min of each coordinate
   * @param max of each coordinate, inclusive
   */
  record Poses(@Nullable RotationForm form, int count, double min, double max) implements TestSpec {
    public Poses {
      requirePositive(count, "count");
      if (!(min <= max) || Double.isInfinite(min) || Double.isInfinite(max)) {
        throw new IllegalArgumentException("min " + min + " is above max " + max);
      }
    }

    @Override
    public String scheme() {
      return "POSE";
    }
  }

  /**
   * The value of another input in the same case plus an offset.
   *
   * @param to name of the other input
   */
  record Related(String to, List<RelatedOffset> offsets) implements TestSpec {
    public Related {
      Objects.requireNonNull(to);
      offsets = List.copyOf(offsets);
      if (offsets.isEmpty()) {
        throw new IllegalArgumentException(
            "offsets needs at least one entry, such as \"0 1ulp -1e-9\"");
      }
    }

    @Override
    public String scheme() {
      return "RELATED";
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
