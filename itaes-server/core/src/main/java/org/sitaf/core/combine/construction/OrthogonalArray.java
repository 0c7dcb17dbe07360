package org.sitaf.core.combine.construction;

import java.util.Optional;

/**
 * Orthogonal arrays of index one (K. A. Bush, Orthogonal arrays of index unity, 1952): each row is
 * a polynomial of degree less than {@code t} over a field with {@code q} elements. The columns are
 * its values at the elements, followed by the leading coefficient.
 */
final class OrthogonalArray {
  private OrthogonalArray() {}

  /** Maximum number of columns. */
  static int columns(int strength, int order) {
    if (strength == 3 && order % 2 == 0) {
      return order + 2;
    }
    return Math.max(order + 1, strength + 1);
  }

  /**
   * The array with {@code order^strength} rows; empty if there is no such field or not enough
   * columns.
   */
  static Optional<int[][]> of(int strength, int order, int columns) {
    return GaloisField.of(order)
        .filter(field -> columns <= columns(strength, order))
        .map(field -> rows(field, strength, columns));
  }

  private static int[][] rows(GaloisField field, int strength, int columns) {
    int q = field.order();
    int size = 1;
    for (int i = 0; i < strength; i++) {
      size *= q;
    }
    boolean parity = columns > q + 1 && !(strength == 3 && q % 2 == 0);
    int[][] rows = new int[size][columns];
    int[] coefficients = new int[strength];
    for (int r = 0; r < size; r++) {
      for (int i = 0, rest = r; i < strength; i++, rest /= q) {
        coefficients[i] = rest % q;
      }
      for (int c = 0; c < columns; c++) {
        rows[r][c] =
            parity ? parity(field, coefficients, c) : value(field, coefficients, strength, c);
      }
    }
    return rows;
  }

  private static int value(GaloisField field, int[] coefficients, int strength, int column) {
    if (column >= field.order()) {
      // The points at infinity: the leading coefficient, and for even q and t = 3 also the middle
      // one.
      return coefficients[strength - 1 - (column - field.order())];
    }
    int value = 0;
    for (int i = strength - 1; i >= 0; i--) {
      value = field.add(field.multiply(value, column), coefficients[i]);
    }
    return value;
  }

  /** For small fields: the coefficients and their sum. */
  private static int parity(GaloisField field, int[] coefficients, int column) {
    if (column < coefficients.length) {
      return coefficients[column];
    }
    int sum = 0;
    for (int coefficient : coefficients) {
      sum = field.add(sum, coefficient);
    }
    return sum;
  }
}
