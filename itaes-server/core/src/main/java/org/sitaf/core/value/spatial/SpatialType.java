package org.sitaf.core.value.spatial;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
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
    return v[0] == 0 && v[1] == 0
        ? new double[] {0, -sine * v[2] + 0.0, cosine * v[2]}
        : new double[] {cosine * v[0] - sine * v[1] + 0.0, sine * v[0] + cosine * v[1] + 0.0, v[2]};
  }

  String literal(Rotation rotation) {
    return rotation(rotation, type);
  }

  String literal(double[] vector) {
    return vector(vector, type);
  }

  String literal(double[] position, Rotation orientation) {
    if (isList(type)) {
      List<Double> cells = new ArrayList<>();
      for (double coordinate : position) {
        cells.add(coordinate);
      }
      cells.addAll(cells(orientation));
      return cells(cells, type);
    }
    if (type instanceof DataType.Struct) {
      requireMembers(List.of(POSITION, ORIENTATION), type);
    }
    return struct(
        type,
        List.of(POSITION, ORIENTATION),
        Map.of(
            POSITION, vector(position, type.member(POSITION)),
            ORIENTATION, rotation(orientation, type.member(ORIENTATION))));
  }

  private String rotation(Rotation rotation, DataType as) {
    if (isList(as)) {
      return cells(cells(rotation), as);
    }
    List<Double> quaternion = List.of(rotation.x(), rotation.y(), rotation.z(), rotation.w());
    return switch (form) {
      case QUATERNION_XYZW -> numbers(as, QUATERNION, quaternion);
      case QUATERNION_WXYZ ->
          as instanceof DataType.Struct
              ? numbers(as, QUATERNION, quaternion)
              : numbers(
                  as,
                  List.of("w", "x", "y", "z"),
                  List.of(rotation.w(), rotation.x(), rotation.y(), rotation.z()));
      case RPY -> numbers(as, ANGLES, boxed(rotation.rpy()));
      case MATRIX ->
          throw new IllegalArgumentException(
              "as=\"matrix\" needs a sequence of nine cells or three rows, not " + name(as));
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
    return isList(as) ? cells(boxed(v), as) : numbers(as, VECTOR, boxed(v));
  }

  /** Cells of a sequence; nine cells of a sequence of sequences are three rows. */
  private static String cells(List<Double> cells, DataType as) {
    DataType element = element(as);
    if (isList(element)) {
      if (cells.size() != 9) {
        throw new IllegalArgumentException(
            name(as) + " has rows, but only as=\"matrix\" is written by rows");
      }
      requireLength(as, 3);
      return List.of(cells.subList(0, 3), cells.subList(3, 6), cells.subList(6, 9)).stream()
          .map(row -> cells(row, element))
          .collect(Collectors.joining(", ", "[", "]"));
    }
    requireLength(as, cells.size());
    return cells.stream()
        .map(cell -> number(cell, element))
        .collect(Collectors.joining(", ", "[", "]"));
  }

  private static void requireLength(DataType as, int length) {
    int bound =
        as instanceof DataType.FixedArray array
            ? array.length()
            : as instanceof DataType.Sequence sequence && sequence.bound() > 0
                ? sequence.bound()
                : length;
    if (bound < length || (as instanceof DataType.FixedArray && bound != length)) {
      throw new IllegalArgumentException(
          name(as) + " cannot hold " + length + " cells; check the attribute as");
    }
  }

  private static String numbers(DataType as, List<String> names, List<Double> numbers) {
    if (!(as instanceof DataType.Struct) && !(as instanceof DataType.Unknown)) {
      throw new IllegalArgumentException(
          name(as) + " cannot hold the members " + String.join(", ", names));
    }
    requireMembers(names, as);
    Map<String, String> literals = new java.util.HashMap<>();
    for (int i = 0; i < names.size(); i++) {
      literals.put(names.get(i), number(numbers.get(i), as.member(names.get(i))));
    }
    return struct(as, names, literals);
  }

  private static void requireMembers(List<String> names, DataType as) {
    if (as instanceof DataType.Struct struct) {
      List<String> members = struct.members().stream().map(DataType.Member::name).toList();
      if (!members.containsAll(names)) {
        throw new IllegalArgumentException(
            struct.name()
                + " needs the members "
                + String.join(", ", names)
                + ", but it has "
                + String.join(", ", members));
      }
    }
  }

  /** The members in the order of the struct; those without a literal have their default. */
  private static String struct(DataType as, List<String> names, Map<String, String> literals) {
    return as instanceof DataType.Struct struct
        ? struct.members().stream()
            .map(
                m ->
                    m.name()
                        + ": "
                        + (literals.containsKey(m.name())
                            ? literals.get(m.name())
                            : defaultOf(m.type())))
            .collect(Collectors.joining(", ", "{", "}"))
        : names.stream()
            .map(name -> name + ": " + literals.get(name))
            .collect(Collectors.joining(", ", "{", "}"));
  }

  private static String defaultOf(DataType type) {
    if (type instanceof DataType.Struct) {
      return struct(type, List.of(), Map.of());
    }
    if (type instanceof DataType.FixedArray array) {
      return String.join(
              ", ", java.util.Collections.nCopies(array.length(), defaultOf(array.element())))
          .transform(cells -> "[" + cells + "]");
    }
    if (type instanceof DataType.Sequence) {
      return "[]";
    }
    if (type instanceof DataType.Enumeration enumeration && !enumeration.literals().isEmpty()) {
      return enumeration.literals().get(0);
    }
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case STRING, CHAR -> "\"\"";
        case BOOLEAN -> "false";
        case FLOAT, DOUBLE -> "0.0";
        default -> "0";
      };
    }
    return "\"\"";
  }

  private static String number(double number, DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      if (scalar.type() == ScalarType.FLOAT) {
        return Float.toString((float) number);
      }
      if (scalar.type() != ScalarType.DOUBLE) {
        throw new IllegalArgumentException(
            "needs floating-point numbers, not " + scalar.typeName());
      }
    }
    return Double.toString(number);
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

  private static boolean isList(DataType type) {
    return type instanceof DataType.Sequence || type instanceof DataType.FixedArray;
  }

  private static DataType element(DataType type) {
    return type.parts().isEmpty() ? new DataType.Unknown("") : type.parts().get(0);
  }

  private static List<Double> boxed(double[] numbers) {
    return java.util.Arrays.stream(numbers).boxed().toList();
  }

  private static String name(DataType type) {
    return type.typeName().isEmpty() ? "the type" : type.typeName();
  }

  private static IllegalArgumentException notSpatial(String literal) {
    return new IllegalArgumentException(
        "'" + literal + "' is not a rotation, a direction or a pose");
  }
}
