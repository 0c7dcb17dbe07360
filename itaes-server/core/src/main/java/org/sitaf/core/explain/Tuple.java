package org.sitaf.core.explain;

import java.util.Arrays;

/**
 * Values of some parameters.
 *
 * @param values index of the value of each parameter; {@link #ANY} if it may have any value
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record Tuple(int[] values) {
  /** The parameter may have any value. */
  public static final int ANY = -1;

  public Tuple {
    values = values.clone();
  }

  /** The values that a row has in the parameters of a mask. */
  static Tuple of(int[] row, long mask) {
    int[] values = new int[row.length];
    for (int i = 0; i < row.length; i++) {
      values[i] = (mask >>> i & 1) == 1 ? row[i] : ANY;
    }
    return new Tuple(values);
  }

  @Override
  public int[] values() {
    return values.clone();
  }

  /** Whether a row has all values. */
  public boolean isIn(int[] row) {
    for (int i = 0; i < values.length; i++) {
      if (values[i] != ANY && values[i] != row[i]) {
        return false;
      }
    }
    return true;
  }

  /** The parameters with a value, one bit for each. */
  long mask() {
    long mask = 0;
    for (int i = 0; i < values.length; i++) {
      if (values[i] != ANY) {
        mask |= 1L << i;
      }
    }
    return mask;
  }

  /** The number of parameters with a value. */
  public int size() {
    return Long.bitCount(mask());
  }

  /** Whether each case with the other tuple has this one, too. */
  boolean isPartOf(Tuple other) {
    for (int i = 0; i < values.length; i++) {
      if (values[i] != ANY && values[i] != other.values[i]) {
        return false;
      }
    }
    return true;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Tuple tuple && Arrays.equals(values, tuple.values);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(values);
  }

  @Override
  public String toString() {
    return Arrays.toString(values);
  }
}
