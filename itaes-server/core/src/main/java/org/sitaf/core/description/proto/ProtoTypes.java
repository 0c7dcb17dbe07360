package org.sitaf.core.description.proto;

import com.squareup.wire.schema.Field;
import com.squareup.wire.schema.Location;
import com.squareup.wire.schema.internal.parser.EnumConstantElement;
import com.squareup.wire.schema.internal.parser.EnumElement;
import com.squareup.wire.schema.internal.parser.FieldElement;
import com.squareup.wire.schema.internal.parser.GroupElement;
import com.squareup.wire.schema.internal.parser.MessageElement;
import com.squareup.wire.schema.internal.parser.TypeElement;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.source.DeclaredTypes;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;

/**
 * Protobuf types by full name. A message becomes a struct, which includes the members of each
 * {@code oneof}. A map becomes a sequence of structs with key and value, as on the wire.
 */
final class ProtoTypes {
  private static final Pattern MAP =
      Pattern.compile("map\\s*<\\s*([\\w.]+)\\s*,\\s*([\\w.]+)\\s*>");

  private static final Map<String, ScalarType> SCALARS =
      Map.ofEntries(
          Map.entry("bool", ScalarType.BOOLEAN),
          Map.entry("double", ScalarType.DOUBLE),
          Map.entry("float", ScalarType.FLOAT),
          Map.entry("int32", ScalarType.INT32),
          Map.entry("sint32", ScalarType.INT32),
          Map.entry("sfixed32", ScalarType.INT32),
          Map.entry("uint32", ScalarType.UINT32),
          Map.entry("fixed32", ScalarType.UINT32),
          Map.entry("int64", ScalarType.INT64),
          Map.entry("sint64", ScalarType.INT64),
          Map.entry("sfixed64", ScalarType.INT64),
          Map.entry("uint64", ScalarType.UINT64),
          Map.entry("fixed64", ScalarType.UINT64),
          Map.entry("string", ScalarType.STRING));

  private final Findings findings;
  private final DeclaredTypes declared;

  ProtoTypes(Findings findings) {
    this.findings = findings;
    this.declared = new DeclaredTypes(findings);
  }

  /**
   * Declares a message or enumeration, including nested ones.
   *
   * @param scope full name of the enclosing package or message; may be empty
   * @param requested whether a duplicate is an error; otherwise the first declaration is used
   */
  void declare(TypeElement type, String scope, String file, boolean requested) {
    String kind = type instanceof EnumElement ? "enum " : "message ";
    Place place = place(file, type.getLocation(), kind + type.getName());
    String full = inside(scope, findings.identifier(type.getName(), place));
    boolean isFirst =
        type instanceof EnumElement enumeration
            ? declared.declare(full, place, () -> enumeration(enumeration, full))
            : declared.declare(full, place, () -> message((MessageElement) type, full, file));
    if (!isFirst && requested) {
      Place first = declared.place(full).orElse(place);
      findings.error(place, "is already declared in " + first.file() + ", line " + first.line());
    }
    type.getNestedTypes().forEach(nested -> declare(nested, full, file, requested));
  }

  /** The structs and enumerations declared in the matching files. */
  List<DataType> declaredIn(Predicate<String> file) {
    return declared.declaredIn(file);
  }

  /** Resolves a type name. An undefined type is reported and becomes {@link DataType.Unknown}. */
  DataType resolve(String name, String scope, Place place) {
    ScalarType scalar = SCALARS.get(name);
    if (scalar != null) {
      return new DataType.Scalar(scalar);
    }
    if (name.equals("bytes")) {
      return new DataType.Sequence(new DataType.Scalar(ScalarType.UINT8));
    }
    String full = find(name, scope).orElse(name.startsWith(".") ? name.substring(1) : name);
    DataType found = declared.find(full).orElse(new DataType.Unknown(full));
    if (found instanceof DataType.Unknown) {
      findings.unknownType(place, full, declared.reason(full));
    }
    return found;
  }

  static String inside(String scope, String name) {
    return scope.isEmpty() ? name : scope + "." + name;
  }

  static Place place(String file, Location location, String element) {
    return new Place(file, Math.max(0, location.getLine()), element);
  }

  /** Searches from the innermost scope outwards, as protoc does. */
  private Optional<String> find(String name, String scope) {
    if (name.startsWith(".")) {
      return Optional.of(name.substring(1)).filter(declared::contains);
    }
    for (String around = scope; ; around = around.substring(0, around.lastIndexOf('.'))) {
      String candidate = inside(around, name);
      if (declared.contains(candidate)) {
        return Optional.of(candidate);
      }
      if (around.isEmpty()) {
        return Optional.empty();
      }
      if (around.indexOf('.') < 0) {
        return Optional.of(name).filter(declared::contains);
      }
    }
  }

  private DataType enumeration(EnumElement enumeration, String full) {
    return new DataType.Enumeration(
        full,
        enumeration.getConstants().stream().map(EnumConstantElement::getName).distinct().toList());
  }

  private DataType message(MessageElement message, String full, String file) {
    List<FieldElement> fields = new ArrayList<>(message.getFields());
    message.getOneOfs().forEach(oneOf -> fields.addAll(oneOf.getFields()));
    // In file order, so the members of a oneof do not come last.
    fields.sort(
        Comparator.comparingInt((FieldElement f) -> f.getLocation().getLine())
            .thenComparingInt(f -> f.getLocation().getColumn()));
    Set<String> names = new HashSet<>();
    List<DataType.Member> members = new ArrayList<>();
    for (FieldElement field : fields) {
      Place at = place(file, field.getLocation(), "message " + full + "/" + field.getName());
      String name = findings.identifier(field.getName(), at);
      if (!names.add(name)) {
        findings.error(at, "two fields have this name");
      }
      members.add(new DataType.Member(name, field(field, full, at)));
    }
    for (GroupElement group : message.getGroups()) {
      findings.warning(
          place(file, group.getLocation(), "message " + full + "/" + group.getName()),
          "groups are not supported, ignored");
    }
    return new DataType.Struct(full, members);
  }

  private DataType field(FieldElement field, String scope, Place place) {
    Matcher map = MAP.matcher(field.getType());
    if (map.matches()) {
      DataType key = resolve(map.group(1), scope, place);
      DataType value = resolve(map.group(2), scope, place);
      return new DataType.Sequence(
          new DataType.Struct(
              inside(scope, entryName(field.getName())),
              List.of(new DataType.Member("key", key), new DataType.Member("value", value))));
    }
    DataType type = resolve(field.getType(), scope, place);
    return field.getLabel() == Field.Label.REPEATED ? new DataType.Sequence(type) : type;
  }

  /**
   * The name that protoc gives to the entry message of a map: {@code joint_limits} becomes {@code
   * JointLimitsEntry}.
   */
  private static String entryName(String field) {
    StringBuilder name = new StringBuilder();
    for (String word : field.split("_", -1)) {
      if (!word.isEmpty()) {
        name.append(Character.toUpperCase(word.charAt(0))).append(word.substring(1));
      }
    }
    return name.append("Entry").toString();
  }
}
