package org.sitaf.core.value.spatial;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

/**
 * Generates whole rotations, directions and poses: first those at which robot code often breaks,
 * then random ones. Equal ones are listed once.
 */
public final class SpatialValues {
  private static final double QUARTER = Math.PI / 2;
  private static final double SMALL = 1e-9;

  /** Draws for one new value before the type is considered exhausted, such as floats. */
  private static final int DRAWS = 100;

  private SpatialValues() {}

  /**
   * The values of a specification.
   *
   * @param random uniform from 0 (inclusive) to 1 (exclusive)
   * @throws IllegalArgumentException if the type cannot hold them
   */
  public static List<Value> rotations(
      TestSpec.Rotations spec, DataType type, DoubleSupplier random) {
    SpatialType written = SpatialType.rotation(type, spec.form());
    return first(
        spec.count(),
        rotations().stream().map(written::literal).toList(),
        () -> written.literal(random(random)));
  }

  /**
   * The values of a specification; as {@link #rotations}.
   *
   * @throws IllegalArgumentException if the type cannot hold them
   */
  public static List<Value> directions(
      TestSpec.Directions spec, DataType type, DoubleSupplier random) {
    SpatialType written = SpatialType.direction(type);
    return first(
        spec.count(),
        directions().stream().map(v -> written.literal(scaled(v, spec.length()))).toList(),
        () -> {
          double z = 2 * random.getAsDouble() - 1;
          double angle = 2 * Math.PI * random.getAsDouble();
          double radius = StrictMath.sqrt(1 - z * z);
          return written.literal(
              scaled(
                  new double[] {radius * StrictMath.cos(angle), radius * StrictMath.sin(angle), z},
                  spec.length()));
        });
  }

  /**
   * The values of a specification; as {@link #rotations}.
   *
   * @throws IllegalArgumentException if the type cannot hold them
   */
  public static List<Value> poses(TestSpec.Poses spec, DataType type, DoubleSupplier random) {
    SpatialType written = SpatialType.pose(type, spec.form());
    List<Rotation> rotations = rotations();
    List<double[]> positions = corners(spec.min(), spec.max());
    List<String> special = new ArrayList<>();
    for (int i = 0; i < Math.max(rotations.size(), positions.size()); i++) {
      special.add(
          written.literal(
              i < positions.size() ? positions.get(i) : position(spec, random),
              i < rotations.size() ? rotations.get(i) : random(random)));
    }
    return first(
        spec.count(), special, () -> written.literal(position(spec, random), random(random)));
  }

  /** Identity, turns of the cube, turns next to pi and 0, pitches next to +-pi/2. */
  private static List<Rotation> rotations() {
    List<Rotation> all = new ArrayList<>();
    all.add(Rotation.IDENTITY);
    for (int axis = 0; axis < 3; axis++) {
      all.add(Rotation.about(axis, Math.PI));
    }
    for (int axis = 0; axis < 3; axis++) {
      all.add(Rotation.about(axis, QUARTER));
      all.add(Rotation.about(axis, -QUARTER));
    }
    for (int[] d : new int[][] {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}) {
      all.add(Rotation.of(0.5, 0.5 * d[0], 0.5 * d[1], 0.5 * d[2]));
      all.add(Rotation.of(0.5, -0.5 * d[0], -0.5 * d[1], -0.5 * d[2]));
    }
    double half = StrictMath.sqrt(0.5);
    all.add(Rotation.of(0, half, half, 0));
    all.add(Rotation.of(0, half, -half, 0));
    all.add(Rotation.of(0, half, 0, half));
    all.add(Rotation.of(0, half, 0, -half));
    all.add(Rotation.of(0, 0, half, half));
    all.add(Rotation.of(0, 0, half, -half));
    for (int axis = 0; axis < 3; axis++) {
      for (double angle :
          new double[] {
            Math.PI - 1e-9, Math.PI + 1e-9, Math.PI - 1e-6, Math.PI + 1e-6, 1e-9, 1e-6
          }) {
        all.add(Rotation.about(axis, angle));
      }
    }
    for (int sign : new int[] {1, -1}) {
      for (double delta : new double[] {0, -SMALL, SMALL}) {
        all.add(Rotation.about(1, sign * (QUARTER + delta)));
      }
    }
    return all;
  }

  /** Axes, edge diagonals, corner diagonals, axes turned a little; of length 1. */
  private static List<double[]> directions() {
    List<double[]> axes = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      for (int sign : new int[] {1, -1}) {
        double[] v = new double[3];
        v[axis] = sign;
        axes.add(v);
      }
    }
    List<double[]> all = new ArrayList<>(axes);
    double edge = StrictMath.sqrt(0.5);
    for (int missing = 2; missing >= 0; missing--) {
      for (int signs = 0; signs < 4; signs++) {
        double[] v = new double[3];
        int next = 0;
        for (int i = 0; i < 3; i++) {
          if (i != missing) {
            v[i] = (signs >> (1 - next++) & 1) == 0 ? edge : -edge;
          }
        }
        all.add(v);
      }
    }
    double corner = StrictMath.sqrt(1.0 / 3);
    for (int signs = 0; signs < 8; signs++) {
      double[] v = new double[3];
      for (int i = 0; i < 3; i++) {
        v[i] = (signs >> (2 - i) & 1) == 0 ? corner : -corner;
      }
      all.add(v);
    }
    axes.forEach(v -> all.add(SpatialType.turned(v, SMALL)));
    return all;
  }

  private static List<double[]> corners(double min, double max) {
    List<double[]> all = new ArrayList<>();
    for (int upper = 0; upper < 8; upper++) {
      double[] position = new double[3];
      for (int i = 0; i < 3; i++) {
        position[i] = (upper >> (2 - i) & 1) == 0 ? min : max;
      }
      all.add(position);
    }
    double middle = min / 2 + max / 2;
    all.add(new double[] {middle, middle, middle});
    return all;
  }

  private static double[] position(TestSpec.Poses spec, DoubleSupplier random) {
    double[] position = new double[3];
    for (int i = 0; i < 3; i++) {
      double share = random.getAsDouble();
      position[i] =
          Math.min(spec.max(), Math.max(spec.min(), spec.min() * (1 - share) + spec.max() * share));
    }
    return position;
  }

  /** A uniform random rotation (Shoemake: Uniform random rotations, Graphics Gems III, 1992). */
  private static Rotation random(DoubleSupplier random) {
    double u = random.getAsDouble();
    double a = 2 * Math.PI * random.getAsDouble();
    double b = 2 * Math.PI * random.getAsDouble();
    double inner = StrictMath.sqrt(1 - u);
    double outer = StrictMath.sqrt(u);
    return Rotation.of(
        outer * StrictMath.cos(b),
        inner * StrictMath.sin(a),
        inner * StrictMath.cos(a),
        outer * StrictMath.sin(b));
  }

  private static double[] scaled(double[] v, double length) {
    return new double[] {v[0] * length + 0.0, v[1] * length + 0.0, v[2] * length + 0.0};
  }

  private static List<Value> first(int count, List<String> special, Supplier<String> random) {
    Set<String> literals = new LinkedHashSet<>();
    for (String literal : special) {
      if (literals.size() < count) {
        literals.add(literal);
      }
    }
    for (long draws = 0; literals.size() < count && draws < (long) DRAWS * count; draws++) {
      Interruption.check();
      literals.add(random.get());
    }
    return literals.stream().map(literal -> (Value) new Value.Text(literal)).toList();
  }
}
