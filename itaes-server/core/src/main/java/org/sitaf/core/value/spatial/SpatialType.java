package org.sitaf.core.value.spatial;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.RotationForm;
import org.sitaf.core.model.TestSpec;

/**
 * How rotations, directions or poses are written as literals of a type. Members of a struct are
 * found by name, cells of a sequence by their order.
 */
public final class SpatialType {
  private enum Content {
    ROTATION,
    DIRECTION,
    POSE
  }

  private static final List<String> QUATERNION = List.of("x", "y", "z", "w");
  private static final List<String> ANGLES = List.of("roll", "pitch", "yaw");
  private static final List<String> VECTOR = List.of("x", "y", "z");
  private static final String POSITION = "position";
  private static final String ORIENTATION = "orientation";

  private final DataType type;
  private final Content content;
  private final RotationForm form;

  private SpatialType(DataType type, Content content, RotationForm form) {
    this.type = type;
    this.content = content;
    this.form = form;
  }

  static SpatialType rotation(DataType type, @Nullable RotationForm form) {
    SpatialType written = new SpatialType(type, Content.ROTATION, form(type, form));
    var unused = written.literal(Rotation.IDENTITY);
    return written;
  }

  static SpatialType direction(DataType type) {
    SpatialType written = new SpatialType(type, Content.DIRECTION, RotationForm.QUATERNION_XYZW);
    var unused = written.literal(new double[] {1, 0, 0});
    return written;
  }

  static SpatialType pose(DataType type, @Nullable RotationForm form) {
    SpatialType written = new SpatialType(type, Content.POSE, form(type.member(ORIENTATION), form));
    var unused = written.literal(new double[3], Rotation.IDENTITY);
    return written;
  }

  /**
   * The type of values that another element follows.
   *
   * @param specs of the element whose values are followed
   * @param literal one of its values
   * @throws IllegalArgumentException if the values are not rotations, directions or poses
   */
  public static SpatialType of(DataType type, List<TestSpec> specs, String literal) {
    for (TestSpec spec : specs) {
      if (spec instanceof TestSpec.Rotations rotations) {
        return rotation(type, rotations.form());
      }
      if (spec instanceof TestSpec.Directions) {
        return direction(type);
      }
      if (spec instanceof TestSpec.Poses poses) {
        return pose(type, poses.form());
      }
    }
    Object plain = Variables.plain(literal, type);
    if (plain instanceof Map<?, ?> members) {
      if (members.containsKey(ORIENTATION)) {
        return pose(type, null);
      }
      return members.containsKey("w") || members.containsKey("yaw")
          ? rotation(type, null)
          : direction(type);
    }
    if (plain instanceof List<?> cells) {
      return switch (cells.size()) {
        case 4 -> rotation(type, null);
        case 9 -> rotation(type, RotationForm.MATRIX);
        case 7 -> pose(type, null);
        case 3 ->
            cells.get(0) instanceof List ? rotation(type, RotationForm.MATRIX) : direction(type);
        default -> throw notSpatial(literal);
      };
    }
    throw notSpatial(literal);
  }

  /**
   * A value turned by an angle about z; a direction parallel to z about x.
   *
   * @param angle in radians
   * @throws IllegalArgumentException if the literal is not such a value
   */
  public String turned(String literal, double angle) {
    Object plain = Variables.plain(literal, type);
    if (angle == 0) {
      return literal;
    }
    return switch (content) {
      case ROTATION -> literal(readRotation(plain, 0).turnedAboutZ(angle));
      case DIRECTION -> literal(turned(readVector(plain), angle));
      case POSE -> {
        Object position = plain instanceof Map<?, ?> m ? m.get(POSITION) : plain;
        Rotation orientation =
            plain instanceof Map<?, ?> m
                ? readRotation(m.get(ORIENTATION), 0)
                : readRotation(plain, 3);
        yield literal(readVector(position), orientation.turnedAboutZ(angle));
      }
    };
  }

  static double[] turned(double[] v, double angle) {
    double sine = StrictMath.sin(angle);
    double cosine = StrictMath.cos(angle);
    if (StrictMath.abs(angle) >= 1) {
      // A half turn gives exactly the opposite direction, where a division by the sine of the
      // angle breaks.
      sine = Rotation.exact(sine);
      cosine = Rotation.exact(cosine);
    }
    return v[0] == 0 && v[1] == 0
        ? new double[] {0, -sine * v[2] + 0.0, cosine * v[2] + 0.0}
        : new double[] {cosine * v[0] - sine * v[1] + 0.0, sine * v[0] + cosine * v[1] + 0.0, v[2]};
  }

  String literal(Rotation rotation) {
    return rotation(rotation, type);
  }

  String literal(double[] vector) {
    return vector(vector, type);
  }

  String literal(double[] position, Rotation orientation) {
    if (NumberLiterals.isList(type)) {
      List<Double> cells = new ArrayList<>();
      for (double coordinate : position) {
        cells.add(coordinate);
      }
      cells.addAll(cells(orientation));
      return NumberLiterals.cells(cells, type);
    }
    if (type instanceof DataType.Struct) {
      NumberLiterals.requireMembers(List.of(POSITION, ORIENTATION), type);
    }
    return NumberLiterals.struct(
        type,
        List.of(POSITION, ORIENTATION),
        Map.of(
            POSITION, vector(position, type.member(POSITION)),
            ORIENTATION, rotation(orientation, type.member(ORIENTATION))));
  }

  private String rotation(Rotation rotation, DataType as) {
    if (NumberLiterals.isList(as)) {
      return NumberLiterals.cells(cells(rotation), as);
    }
    List<Double> quaternion = List.of(rotation.x(), rotation.y(), rotation.z(), rotation.w());
    return switch (form) {
      case QUATERNION_XYZW -> NumberLiterals.members(as, QUATERNION, quaternion);
      case QUATERNION_WXYZ ->
          as instanceof DataType.Struct
              ? NumberLiterals.members(as, QUATERNION, quaternion)
              : NumberLiterals.members(
                  as,
                  List.of("w", "x", "y", "z"),
                  List.of(rotation.w(), rotation.x(), rotation.y(), rotation.z()));
      case RPY -> NumberLiterals.members(as, ANGLES, boxed(rotation.rpy()));
      case MATRIX ->
          throw new IllegalArgumentException(
              "as=\"matrix\" needs a sequence of nine cells or three rows, not "
                  + NumberLiterals.name(as));
    };
  }

  private List<Double> cells(Rotation r) {
    return switch (form) {
      case QUATERNION_XYZW -> List.of(r.x(), r.y(), r.z(), r.w());
      case QUATERNION_WXYZ -> List.of(r.w(), r.x(), r.y(), r.z());
      case RPY -> boxed(r.rpy());
      case MATRIX -> boxed(r.matrix());
    };
  }

  private static String vector(double[] v, DataType as) {
    return NumberLiterals.isList(as)
        ? NumberLiterals.cells(boxed(v), as)
        : NumberLiterals.members(as, VECTOR, boxed(v));
  }

  private Rotation readRotation(@Nullable Object plain, int from) {
    if (plain instanceof Map<?, ?> members) {
      return members.containsKey("w")
          ? Rotation.of(
              real(members.get("w")),
              real(members.get("x")),
              real(members.get("y")),
              real(members.get("z")))
          : Rotation.ofRpy(
              real(members.get("roll")), real(members.get("pitch")), real(members.get("yaw")));
    }
    List<Double> cells = new ArrayList<>();
    flatten(plain, cells);
    double[] c = cells.stream().skip(from).mapToDouble(Double::doubleValue).toArray();
    int expected = form == RotationForm.MATRIX ? 9 : form == RotationForm.RPY ? 3 : 4;
    if (c.length != expected) {
      throw notSpatial(String.valueOf(plain));
    }
    return switch (form) {
      case QUATERNION_XYZW -> Rotation.of(c[3], c[0], c[1], c[2]);
      case QUATERNION_WXYZ -> Rotation.of(c[0], c[1], c[2], c[3]);
      case RPY -> Rotation.ofRpy(c[0], c[1], c[2]);
      case MATRIX -> Rotation.ofMatrix(c);
    };
  }

  private static double[] readVector(@Nullable Object plain) {
    if (plain instanceof Map<?, ?> members) {
      return new double[] {real(members.get("x")), real(members.get("y")), real(members.get("z"))};
    }
    List<Double> cells = new ArrayList<>();
    flatten(plain, cells);
    if (cells.size() < 3) {
      throw notSpatial(String.valueOf(plain));
    }
    return new double[] {cells.get(0), cells.get(1), cells.get(2)};
  }

  private static void flatten(@Nullable Object plain, List<Double> cells) {
    if (plain instanceof List<?> list) {
      list.forEach(item -> flatten(item, cells));
    } else {
      cells.add(real(plain));
    }
  }

  private static double real(@Nullable Object number) {
    if (number instanceof Number n) {
      return n.doubleValue();
    }
    throw notSpatial(String.valueOf(number));
  }

  private static RotationForm form(DataType type, @Nullable RotationForm given) {
    if (given != null) {
      return given;
    }
    boolean angles =
        type instanceof DataType.Struct struct
            && struct.members().stream().map(DataType.Member::name).toList().containsAll(ANGLES);
    return angles ? RotationForm.RPY : RotationForm.QUATERNION_XYZW;
  }

  private static List<Double> boxed(double[] numbers) {
    return java.util.Arrays.stream(numbers).boxed().toList();
  }

  private static IllegalArgumentException notSpatial(String literal) {
    return new IllegalArgumentException(
        "'" + literal + "' is not a rotation, a direction or a pose");
  }
}
