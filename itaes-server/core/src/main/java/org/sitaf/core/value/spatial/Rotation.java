package org.sitaf.core.value.spatial;

/**
 * A rotation as a unit quaternion.
 *
 * @param rpy roll, pitch and yaw in radians about fixed x, y and z, in this order
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
record Rotation(double w, double x, double y, double z, double[] rpy) {
  static final Rotation IDENTITY = new Rotation(1, 0, 0, 0, new double[3]);

  private static final double HALF_ROOT = StrictMath.sqrt(0.5);

  /** Values to which results of trigonometric functions are rounded. */
  private static final double[] EXACT = {0, 0.5, HALF_ROOT, 1};

  private static final double ROUNDING = 1e-15;

  Rotation {
    double sign = firstNonZero(w, x, y, z) < 0 ? -1 : 1;
    // Adding 0.0 turns -0.0 into 0.0.
    w = sign * w + 0.0;
    x = sign * x + 0.0;
    y = sign * y + 0.0;
    z = sign * z + 0.0;
    rpy = rpy.clone();
    for (int i = 0; i < 3; i++) {
      rpy[i] += 0.0;
    }
  }

  @Override
  public double[] rpy() {
    return rpy.clone();
  }

  /**
   * A turn about a coordinate axis. The angle is kept in roll, pitch or yaw as it is given.
   *
   * @param axis 0 to 2
   */
  static Rotation about(int axis, double angle) {
    double[] rpy = new double[3];
    rpy[axis] = angle;
    double sine = exact(StrictMath.sin(angle / 2));
    return new Rotation(
        exact(StrictMath.cos(angle / 2)),
        axis == 0 ? sine : 0,
        axis == 1 ? sine : 0,
        axis == 2 ? sine : 0,
        rpy);
  }

  /** The rotation of a quaternion that is not zero. It is normalized. */
  static Rotation of(double w, double x, double y, double z) {
    double norm = StrictMath.sqrt(w * w + x * x + y * y + z * z);
    if (!(norm > 0) || Double.isInfinite(norm)) {
      return new Rotation(w, x, y, z, new double[] {Double.NaN, Double.NaN, Double.NaN});
    }
    boolean unit = StrictMath.abs(norm - 1) <= ROUNDING;
    double scale = unit ? 1 : norm;
    Rotation plain = new Rotation(w / scale, x / scale, y / scale, z / scale, new double[3]);
    return new Rotation(plain.w, plain.x, plain.y, plain.z, rpy(plain.matrix()));
  }

  /** The rotation of a matrix by rows (Shepperd's method). */
  static Rotation ofMatrix(double[] m) {
    double trace = m[0] + m[4] + m[8];
    if (trace >= m[0] && trace >= m[4] && trace >= m[8]) {
      double w = StrictMath.sqrt(1 + trace) / 2;
      return of(w, (m[7] - m[5]) / (4 * w), (m[2] - m[6]) / (4 * w), (m[3] - m[1]) / (4 * w));
    }
    if (m[0] >= m[4] && m[0] >= m[8]) {
      double x = StrictMath.sqrt(1 + m[0] - m[4] - m[8]) / 2;
      return of((m[7] - m[5]) / (4 * x), x, (m[1] + m[3]) / (4 * x), (m[2] + m[6]) / (4 * x));
    }
    if (m[4] >= m[8]) {
      double y = StrictMath.sqrt(1 - m[0] + m[4] - m[8]) / 2;
      return of((m[2] - m[6]) / (4 * y), (m[1] + m[3]) / (4 * y), y, (m[5] + m[7]) / (4 * y));
    }
    double z = StrictMath.sqrt(1 - m[0] - m[4] + m[8]) / 2;
    return of((m[3] - m[1]) / (4 * z), (m[2] + m[6]) / (4 * z), (m[5] + m[7]) / (4 * z), z);
  }

  /** The rotation of roll, pitch and yaw. */
  static Rotation ofRpy(double roll, double pitch, double yaw) {
    Rotation turned = about(2, yaw).after(about(1, pitch)).after(about(0, roll));
    return new Rotation(turned.w, turned.x, turned.y, turned.z, new double[] {roll, pitch, yaw});
  }

  /** This rotation applied after another one, both about fixed axes. */
  Rotation after(Rotation first) {
    return of(
        w * first.w - x * first.x - y * first.y - z * first.z,
        w * first.x + x * first.w + y * first.z - z * first.y,
        w * first.y - x * first.z + y * first.w + z * first.x,
        w * first.z + x * first.y - y * first.x + z * first.w);
  }

  /** This rotation, then a turn about fixed z, which changes only the yaw. */
  Rotation turnedAboutZ(double angle) {
    Rotation turned = about(2, angle).after(this);
    return new Rotation(
        turned.w, turned.x, turned.y, turned.z, new double[] {rpy[0], rpy[1], rpy[2] + angle});
  }

  /** The matrix by rows. */
  double[] matrix() {
    return new double[] {
      exact(1 - 2 * (y * y + z * z)), exact(2 * (x * y - w * z)), exact(2 * (x * z + w * y)),
      exact(2 * (x * y + w * z)), exact(1 - 2 * (x * x + z * z)), exact(2 * (y * z - w * x)),
      exact(2 * (x * z - w * y)), exact(2 * (y * z + w * x)), exact(1 - 2 * (x * x + y * y))
    };
  }

  /** A vector after this rotation. */
  double[] rotate(double[] v) {
    double[] m = matrix();
    return new double[] {
      m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + 0.0,
      m[3] * v[0] + m[4] * v[1] + m[5] * v[2] + 0.0,
      m[6] * v[0] + m[7] * v[1] + m[8] * v[2] + 0.0
    };
  }

  private static double[] rpy(double[] m) {
    double horizontal = StrictMath.hypot(m[7], m[8]);
    double pitch = StrictMath.atan2(-m[6], horizontal);
    // At a pitch of +-pi/2 only yaw - roll or yaw + roll is determined; the yaw is set to 0.
    return horizontal == 0
        ? new double[] {StrictMath.atan2(-m[5], m[4]), pitch, 0}
        : new double[] {StrictMath.atan2(m[7], m[8]), pitch, StrictMath.atan2(m[3], m[0])};
  }

  private static double firstNonZero(double... numbers) {
    for (double number : numbers) {
      if (number != 0) {
        return number;
      }
    }
    return 0;
  }

  /** The number, or the value of a common angle from which only rounding separates it. */
  static double exact(double number) {
    for (double candidate : EXACT) {
      if (StrictMath.abs(StrictMath.abs(number) - candidate) <= ROUNDING) {
        return number < 0 ? 0.0 - candidate : candidate;
      }
    }
    return number;
  }
}
