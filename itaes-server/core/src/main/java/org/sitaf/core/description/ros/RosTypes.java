package org.sitaf.core.description.ros;

import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.source.DeclaredTypes;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;

/** Types of ROS 2. A message becomes a struct named {@code package/Message}. */
final class RosTypes {
  /** Types that ROS 1 knows without a package, and what replaces them. */
  private static final Map<String, String> ONLY_IN_ROS_1 =
      Map.of(
          "time", "builtin_interfaces/Time",
          "duration", "builtin_interfaces/Duration",
          "Header", "std_msgs/Header");

  private static final Pattern TYPE =
      Pattern.compile("([A-Za-z][\\w/]{0,300})(?:<=([0-9]{1,9}))?(\\[(?:(<=)?([0-9]{1,9}))?\\])?");

  private static final int MAX_LENGTH = 1_000_000;

  private static final Map<String, ScalarType> SCALARS =
      Map.ofEntries(
          Map.entry("bool", ScalarType.BOOLEAN),
          Map.entry("byte", ScalarType.UINT8),
          // As in rosidl: an unsigned number.
          Map.entry("char", ScalarType.UINT8),
          Map.entry("float32", ScalarType.FLOAT),
          Map.entry("float64", ScalarType.DOUBLE),
          Map.entry("int8", ScalarType.INT8),
          Map.entry("uint8", ScalarType.UINT8),
          Map.entry("int16", ScalarType.INT16),
          Map.entry("uint16", ScalarType.UINT16),
          Map.entry("int32", ScalarType.INT32),
          Map.entry("uint32", ScalarType.UINT32),
          Map.entry("int64", ScalarType.INT64),
          Map.entry("uint64", ScalarType.UINT64),
          Map.entry("string", ScalarType.STRING),
          Map.entry("wstring", ScalarType.STRING));

  private final Findings findings;
  private final DeclaredTypes declared;

  RosTypes(Findings findings) {
    this.findings = findings;
    this.declared = new DeclaredTypes(findings);
  }

  /** Declares a message. The first of several declarations is used. */
  void declare(RosFile message) {
    Place place = new Place(message.path(), 1, message.name().name());
    declared.declare(
        message.name().qualified(),
        place,
        () -> struct(message.name().qualified(), message.sections().get(0), message));
  }

  /** Creates a struct from fields. */
  DataType.Struct struct(String name, List<RosFile.Field> fields, RosFile file) {
    return new DataType.Struct(
        name, fields.stream().map(f -> new DataType.Member(f.name(), resolve(f, file))).toList());
  }

  /** The structs declared in the matching files. */
  List<DataType> declaredIn(Predicate<String> file) {
    return declared.declaredIn(file);
  }

  /**
   * Resolves the type of a field. An undefined type is reported and becomes {@link
   * DataType.Unknown}.
   */
  DataType resolve(RosFile.Field field, RosFile file) {
    Place place = new Place(file.path(), field.line(), "field " + field.name());
    Matcher match = TYPE.matcher(field.type());
    if (!match.matches()) {
      findings.error(
          place,
          "'"
              + field.type()
              + "' is not a type, such as float64, string<=10, Point[3] or"
              + " geometry_msgs/Pose[<=5]");
      return new DataType.Unknown(field.type());
    }
    DataType element = element(match.group(1), match.group(2), file, place);
    if (match.group(3) == null) {
      return element;
    }
    if (match.group(5) == null) {
      return new DataType.Sequence(element);
    }
    int length = length(match.group(5), place);
    return match.group(4) == null
        ? new DataType.FixedArray(element, length)
        : new DataType.Sequence(element, length);
  }

  private DataType element(
      String name, @org.jspecify.annotations.Nullable String bound, RosFile file, Place place) {
    ScalarType scalar = SCALARS.get(name);
    if (bound != null && scalar != ScalarType.STRING) {
      findings.error(place, "only a string can have a bound such as '<=" + bound + "'");
    }
    if (scalar != null) {
      return scalar == ScalarType.STRING && bound != null
          ? new DataType.Scalar(scalar, length(bound, place))
          : new DataType.Scalar(scalar);
    }
    // geometry_msgs/msg/Pose is the same as geometry_msgs/Pose.
    String plain = name.replaceFirst("^(\\w+)/msg/(\\w+)$", "$1/$2");
    String own = file.name().packageName();
    String qualified = plain.contains("/") || own.isEmpty() ? plain : own + "/" + plain;
    DataType found = declared.find(qualified).orElse(new DataType.Unknown(qualified));
    if (found instanceof DataType.Unknown) {
      findings.unknownType(place, qualified, reason(name, qualified));
    }
    return found;
  }

  /** Why a type is unknown: it cannot be represented, or only ROS 1 has it; empty otherwise. */
  private String reason(String written, String qualified) {
    String inRos2 = ONLY_IN_ROS_1.get(written);
    return inRos2 == null
        ? declared.reason(qualified)
        : "this is a file of ROS 1; in ROS 2, '" + written + "' is '" + inRos2 + "'";
  }

  private int length(String digits, Place place) {
    int length = Integer.parseInt(digits);
    if (length < 1 || length > MAX_LENGTH) {
      findings.error(place, "a length or bound must be 1 to " + MAX_LENGTH + ", not " + digits);
      return 1;
    }
    return length;
  }
}
