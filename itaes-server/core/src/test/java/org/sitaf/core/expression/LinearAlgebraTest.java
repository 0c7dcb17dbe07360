package org.sitaf.core.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;

/** Vectors, matrices and quaternions against independent computations. */
class LinearAlgebraTest {
  private static final ExpressionCompiler COMPILER =
      new ExpressionCompiler(Set.of("a", "b", "v", "p", "q"));

  private static Object value(String text, Object... variables) {
    Map<String, Object> values = new HashMap<>();
    for (int i = 0; i < variables.length; i += 2) {
      values.put((String) variables[i], variables[i + 1]);
    }
    try {
      return COMPILER.compile(text).evaluate(values);
    } catch (EvaluationException e) {
      throw new AssertionError(text, e);
    }
  }

  private static double number(String text, Object... variables) {
    return ((Number) value(text, variables)).doubleValue();
  }

  @Property(tries = 300)
  void theNormIsTheRootOfTheExactSumOfSquares(
      @ForAll @Size(max = 6) List<@DoubleRange(min = -1e150, max = 1e150) Double> v) {
    BigDecimal squares =
        v.stream().map(x -> new BigDecimal(x).pow(2)).reduce(BigDecimal.ZERO, BigDecimal::add);
    double exact = squares.sqrt(new MathContext(40)).doubleValue();
    assertThat(number("norm(v)", "v", v)).isCloseTo(exact, within(exact * 1e-14));
  }

  @Property(tries = 300)
  void theDeterminantIsTheSumOverAllPermutations(
      @ForAll @IntRange(min = 1, max = 5) int n,
      @ForAll @Size(25) List<@IntRange(min = -9, max = 9) Integer> cells) {
    long[][] matrix = new long[n][n];
    List<List<Object>> rows = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      List<Object> row = new ArrayList<>();
      for (int j = 0; j < n; j++) {
        matrix[i][j] = cells.get(i * n + j);
        row.add(matrix[i][j]);
      }
      rows.add(row);
    }
    assertThat(number("det(a)", "a", rows)).isCloseTo(leibniz(matrix), within(1e-8));
    assertThat(number("det(transpose(a))", "a", rows)).isCloseTo(leibniz(matrix), within(1e-8));
    assertThat(value("near(matmul(a, identity(" + n + ")), a, 0)", "a", rows)).isEqualTo(true);
  }

  /** By the first row; exact over whole numbers. */
  private static long leibniz(long[][] matrix) {
    if (matrix.length == 1) {
      return matrix[0][0];
    }
    long sum = 0;
    for (int column = 0; column < matrix.length; column++) {
      long[][] minor = new long[matrix.length - 1][matrix.length - 1];
      for (int i = 1; i < matrix.length; i++) {
        for (int j = 0; j < matrix.length - 1; j++) {
          minor[i - 1][j] = matrix[i][j < column ? j : j + 1];
        }
      }
      sum += (column % 2 == 0 ? 1 : -1) * matrix[0][column] * leibniz(minor);
    }
    return sum;
  }

  @Property(tries = 300)
  void theVectorProductIsOrthogonalAndAsLongAsTheParallelogramIsLarge(
      @ForAll @Size(3) List<@IntRange(min = -1000, max = 1000) Integer> u,
      @ForAll @Size(3) List<@IntRange(min = -1000, max = 1000) Integer> v) {
    List<Long> a = u.stream().map(Integer::longValue).toList();
    List<Long> b = v.stream().map(Integer::longValue).toList();
    assertThat(number("dot(cross(a, b), a)", "a", a, "b", b)).isZero();
    assertThat(number("dot(cross(a, b), b)", "a", a, "b", b)).isZero();
    // Lagrange's identity.
    assertThat(number("dot(cross(a, b), cross(a, b)) + dot(a, b) * dot(a, b)", "a", a, "b", b))
        .isEqualTo(number("dot(a, a) * dot(b, b)", "a", a, "b", b));
  }

  @Property(tries = 300)
  void aRotationByAQuaternionIsThatByItsMatrix(
      @ForAll @Size(4) List<@DoubleRange(min = -1, max = 1) Double> parts,
      @ForAll @Size(3) List<@DoubleRange(min = -10, max = 10) Double> v) {
    double length = Math.sqrt(parts.stream().mapToDouble(p -> p * p).sum());
    if (length < 1e-3) {
      return;
    }
    double x = parts.get(0) / length;
    double y = parts.get(1) / length;
    double z = parts.get(2) / length;
    double w = parts.get(3) / length;
    List<List<Double>> matrix =
        List.of(
            List.of(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            List.of(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            List.of(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)));
    // The quaternion does not need to be normalized.
    Map<String, Object> q = quaternion(parts.get(0), parts.get(1), parts.get(2), parts.get(3));
    assertThat(value("near(qrotate(q, v), matmul(a, v), 1e-12)", "q", q, "v", v, "a", matrix))
        .isEqualTo(true);
  }

  @Property(tries = 300)
  void theProductRotatesByTheSecondFactorFirst(
      @ForAll @Size(8) List<@DoubleRange(min = 0.1, max = 1) Double> parts,
      @ForAll @Size(3) List<@DoubleRange(min = -10, max = 10) Double> v) {
    Map<String, Object> p = quaternion(parts.get(0), -parts.get(1), parts.get(2), parts.get(3));
    Map<String, Object> q = quaternion(-parts.get(4), parts.get(5), parts.get(6), parts.get(7));
    assertThat(
            value(
                "near(qrotate(qmul(p, q), v), qrotate(p, qrotate(q, v)), 1e-12)",
                "p",
                p,
                "q",
                q,
                "v",
                v))
        .isEqualTo(true);
    assertThat(value("near(qnorm(qmul(p, q)), qnorm(p) * qnorm(q), 1e-12)", "p", p, "q", q))
        .isEqualTo(true);
    assertThat(value("near(qrotate(qmul(qconj(q), q), v), v, 1e-12)", "q", q, "v", v))
        .isEqualTo(true);
  }

  @Property(tries = 300)
  void theAngleBetweenRotationsIsThatOfTheTurn(
      @ForAll @DoubleRange(min = 0, max = 3.14) double angle) {
    Map<String, Object> q = quaternion(0, 0, Math.sin(angle / 2), Math.cos(angle / 2));
    Map<String, Object> p = quaternion(0, 0, 0, 1);
    assertThat(number("qangle(q, p)", "q", q, "p", p)).isCloseTo(angle, within(1e-14));
    Map<String, Object> opposite = quaternion(0, 0, 0, -1);
    assertThat(number("qangle(q, p)", "q", q, "p", opposite)).isCloseTo(angle, within(1e-14));
  }

  @Property(tries = 500)
  void aWrappedAngleHasTheSameDirectionAndIsInRange(
      @ForAll @DoubleRange(min = -1000, max = 1000) double angle) {
    double wrapped = number("wrap_angle(a)", "a", angle);
    assertThat(wrapped).isGreaterThan(-Math.PI).isLessThanOrEqualTo(Math.PI);
    assertThat(Math.sin(wrapped)).isCloseTo(Math.sin(angle), within(1e-12));
    assertThat(Math.cos(wrapped)).isCloseTo(Math.cos(angle), within(1e-12));
    assertThat(number("angle_difference(a, b)", "a", angle, "b", 1.0))
        .isEqualTo(number("wrap_angle(a - b)", "a", angle, "b", 1.0));
  }

  private static Map<String, Object> quaternion(double x, double y, double z, double w) {
    return Map.of("x", x, "y", y, "z", z, "w", w);
  }
}
