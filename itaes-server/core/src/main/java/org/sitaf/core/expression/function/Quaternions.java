package org.sitaf.core.expression.function;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hipparchus.complex.Quaternion;

/**
 * Functions of quaternions: structs with the members x, y, z and w. Rotations do not need to be
 * normalized; the zero quaternion is no rotation, so it is outside of their domain.
 */
final class Quaternions {
  private static final List<String> MEMBERS = List.of("x", "y", "z", "w");

  private Quaternions() {}

  /** The Hamilton product: the rotation b, then the rotation a. */
  static Object product(Object a, Object b) {
    return struct(of("qmul", a).multiply(of("qmul", b)));
  }

  static Object conjugate(Object q) {
    return struct(of("qconj", q).getConjugate());
  }

  static double norm(Object q) {
    Quaternion quaternion = of("qnorm", q);
    return Vectors.norm(
        new double[] {
          quaternion.getQ0(), quaternion.getQ1(), quaternion.getQ2(), quaternion.getQ3()
        });
  }

  /** The rotated vector, in the form of the vector. */
  static Object rotate(Object q, Object v) {
    Quaternion rotation = of("qrotate", q);
    double[] vector = Vectors.numbers("qrotate", v);
    if (vector.length != 3) {
      throw new IllegalArgumentException(
          "qrotate needs a vector of 3 numbers, not of " + vector.length);
    }
    // v + 2 / |q|^2 (w (u x v) + u x (u x v)), with the vector part u of the quaternion.
    double w = rotation.getScalarPart();
    double[] u = rotation.getVectorPart();
    double factor = 2 / (w * w + u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    double[] once = Vectors.cross(u, vector);
    double[] twice = Vectors.cross(u, once);
    double[] rotated = new double[3];
    for (int i = 0; i < 3; i++) {
      rotated[i] = vector[i] + factor * (w * once[i] + twice[i]);
    }
    return Vectors.like(v, rotated);
  }

  /**
   * The angle between two rotations in radians, from 0 to pi. The arc tangent is exact for small
   * angles, where the arc cosine of the scalar product is not.
   */
  static double angle(Object q, Object p) {
    if (norm(q) == 0 || norm(p) == 0) {
      return Double.NaN;
    }
    Quaternion between = of("qangle", q).getConjugate().multiply(of("qangle", p));
    return 2
        * StrictMath.atan2(
            Vectors.norm(between.getVectorPart()), Math.abs(between.getScalarPart()));
  }

  private static Quaternion of(String function, Object value) {
    if (!(value instanceof Map<?, ?> map) || !map.keySet().containsAll(MEMBERS)) {
      throw new IllegalArgumentException(
          function + " needs a struct with x, y, z and w, not " + Numbers.shown(value));
    }
    double[] parts = new double[4];
    for (int i = 0; i < 4; i++) {
      Object part = map.get(MEMBERS.get(i));
      if (part == null || !Numbers.isNumber(part)) {
        throw new IllegalArgumentException(
            function + " needs numbers, not " + Numbers.shown(String.valueOf(part)));
      }
      parts[i] = Numbers.real(part);
    }
    return new Quaternion(parts[3], parts[0], parts[1], parts[2]);
  }

  private static Object struct(Quaternion q) {
    Map<String, Object> struct = new LinkedHashMap<>();
    struct.put("x", q.getQ1());
    struct.put("y", q.getQ2());
    struct.put("z", q.getQ3());
    struct.put("w", q.getQ0());
    return struct;
  }
}
