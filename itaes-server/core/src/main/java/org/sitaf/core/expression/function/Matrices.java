package org.sitaf.core.expression.function;

import java.util.ArrayList;
import java.util.List;
import org.hipparchus.linear.LUDecomposition;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;

/** Functions of matrices: lists of rows of the same length. */
final class Matrices {
  /** Largest {@code identity(n)}. */
  private static final int MAX_SIZE = 1_000;

  private Matrices() {}

  /** The product of two matrices, or of a matrix and a vector. */
  static Object matmul(Object a, Object b) {
    RealMatrix left = matrix("matmul", a);
    if (!isMatrix(b)) {
      double[] vector = Vectors.numbers("matmul", b);
      requireFit(left, vector.length);
      return Vectors.like(b, left.operate(vector));
    }
    RealMatrix right = matrix("matmul", b);
    requireFit(left, right.getRowDimension());
    return rows(left.multiply(right));
  }

  private static void requireFit(RealMatrix left, int rows) {
    if (left.getColumnDimension() != rows) {
      throw new IllegalArgumentException(
          "matmul needs as many columns as the second matrix has rows, not "
              + left.getColumnDimension()
              + " and "
              + rows);
    }
  }

  static Object transpose(Object matrix) {
    return rows(matrix("transpose", matrix).transpose());
  }

  /** The determinant: in closed form up to three rows, otherwise by LU decomposition. */
  static double det(Object matrix) {
    RealMatrix m = matrix("det", matrix);
    if (!m.isSquare()) {
      throw new IllegalArgumentException(
          "det needs a square matrix, not "
              + m.getRowDimension()
              + " rows and "
              + m.getColumnDimension()
              + " columns");
    }
    return switch (m.getRowDimension()) {
      case 1 -> m.getEntry(0, 0);
      case 2 -> m.getEntry(0, 0) * m.getEntry(1, 1) - m.getEntry(0, 1) * m.getEntry(1, 0);
      case 3 -> {
        double[] product = Vectors.cross(m.getRow(1), m.getRow(2));
        double[] first = m.getRow(0);
        yield first[0] * product[0] + first[1] * product[1] + first[2] * product[2];
      }
      // A pivot that is not zero is not singular, however small.
      default -> new LUDecomposition(m, Double.MIN_VALUE).getDeterminant();
    };
  }

  static Object identity(Object n) {
    if (!(n instanceof Long size) || size < 1 || size > MAX_SIZE) {
      throw new IllegalArgumentException(
          "identity needs a whole number from 1 to " + MAX_SIZE + ", not " + Numbers.shown(n));
    }
    return rows(MatrixUtils.createRealIdentityMatrix(size.intValue()));
  }

  private static boolean isMatrix(Object value) {
    return value instanceof List<?> rows && !rows.isEmpty() && Vectors.isVector(rows.get(0));
  }

  private static RealMatrix matrix(String function, Object value) {
    if (!isMatrix(value)) {
      throw new IllegalArgumentException(
          function
              + " needs a matrix, a list of rows such as [[1, 2], [3, 4]], not "
              + Numbers.shown(value));
    }
    List<?> rows = (List<?>) value;
    double[][] cells = new double[rows.size()][];
    int i = 0;
    for (Object row : rows) {
      cells[i] = Vectors.numbers(function, row);
      if (cells[i].length == 0 || cells[i].length != cells[0].length) {
        throw new IllegalArgumentException(function + " needs rows of the same length");
      }
      i++;
    }
    return MatrixUtils.createRealMatrix(cells);
  }

  private static List<Object> rows(RealMatrix matrix) {
    List<Object> rows = new ArrayList<>(matrix.getRowDimension());
    for (int i = 0; i < matrix.getRowDimension(); i++) {
      rows.add(Vectors.like(List.of(), matrix.getRow(i)));
    }
    return rows;
  }
}
