package org.sitaf.core.model;

import java.math.BigDecimal;
import java.util.List;
import java.util.Objects;

/** The equivalence class of valid values (paper, Table 1). */
public sealed interface EquivalenceClass {

  /** Whether a number belongs to the class. */
  boolean contains(BigDecimal number);

  /**
   * NEC_NUMERIC_ONE_BOUNDARY.
   *
   * @param lower whether the boundary is the minimum; otherwise it is the maximum
   */
  record OneBoundary(BigDecimal boundary, boolean lower, boolean inclusive)
      implements EquivalenceClass {
    public OneBoundary {
      Objects.requireNonNull(boundary);
    }

    @Override
    public boolean contains(BigDecimal number) {
      int order = number.compareTo(boundary);
      return (inclusive && order == 0) || (lower ? order > 0 : order < 0);
    }
  }

  /** NEC_NUMERIC_TWO_BOUNDARY. */
  record TwoBoundary(BigDecimal min, BigDecimal max, boolean minInclusive, boolean maxInclusive)
      implements EquivalenceClass {
    public TwoBoundary {
      if (min.compareTo(max) > 0) {
        throw new IllegalArgumentException("min " + min + " is above max " + max);
      }
    }

    @Override
    public boolean contains(BigDecimal number) {
      int below = number.compareTo(min);
      int above = number.compareTo(max);
      return (below > 0 || (minInclusive && below == 0))
          && (above < 0 || (maxInclusive && above == 0));
    }
  }

  /**
   * NEC_BOOLEAN.
   *
   * @param trueOnly whether false is invalid
   */
  record BooleanClass(boolean trueOnly) implements EquivalenceClass {
    @Override
    public boolean contains(BigDecimal number) {
      return !trueOnly || number.signum() != 0;
    }
  }

  /** NEC_NUMERIC_CONSTANT. */
  record Constant(BigDecimal value) implements EquivalenceClass {
    public Constant {
      Objects.requireNonNull(value);
    }

    @Override
    public boolean contains(BigDecimal number) {
      return number.compareTo(value) == 0;
    }
  }

  /** NEC_NUMERIC_SET. */
  record NumericSet(List<BigDecimal> members) implements EquivalenceClass {
    public NumericSet {
      members = List.copyOf(members);
      if (members.isEmpty()) {
        throw new IllegalArgumentException("a set class needs at least one value");
      }
    }

    @Override
    public boolean contains(BigDecimal number) {
      return members.stream().anyMatch(m -> m.compareTo(number) == 0);
    }
  }
}
