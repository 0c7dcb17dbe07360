package org.sitaf.core.harness.java.plan;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Value;

/**
 * The Java type of an interface type: unsigned integers are mapped to the next wider type (64 bits
 * to {@code BigInteger}), sequences and arrays to Java arrays, structs to generated records,
 * enumerations to generated enums.
 *
 * @param name name in declarations
 * @param boxed name as a type argument
 * @param accessor method of the runtime's {@code TestCase} that reads a value
 * @param zero expression of the default value
 * @param type type of the interface
 * @param imports imports of the type
 */
public record JavaType(
    String name, String boxed, String accessor, String zero, DataType type, Set<String> imports) {
  /** The package of generated interfaces and types. */
  public static final String INTERFACES = "sitaf.interfaces";

  /** The message for unsupported types. */
  static final String SUPPORTED = "this type is not supported in Java";

  /** Maximum length of an array of objects, whose elements are written individually. */
  private static final int MAX_WRITTEN = 64;

  public JavaType {
    imports = Set.copyOf(imports);
  }

  /** The Java type; empty for {@code void} and unsupported types. */
  static Optional<JavaType> of(DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      return Optional.ofNullable(scalar(scalar));
    }
    if (type instanceof DataType.Sequence sequence) {
      return of(sequence.element()).map(e -> array(e, sequence, 0));
    }
    if (type instanceof DataType.FixedArray fixed) {
      return of(fixed.element())
          .filter(e -> isPrimitive(e) || fixed.length() <= MAX_WRITTEN)
          .map(e -> array(e, fixed, fixed.length()));
    }
    if (type instanceof DataType.Struct || type instanceof DataType.Enumeration) {
      String name = JavaNames.DECLARED.type(type);
      String zero =
          type instanceof DataType.Enumeration enumeration
              ? name + "." + JavaNames.DECLARED.literal(enumeration.literals().get(0))
              : "new " + name + "()";
      return Optional.of(
          new JavaType(name, name, "value", zero, type, Set.of(INTERFACES + "." + name)));
    }
    return Optional.empty();
  }

  /** The arguments of the accessor for a value of the case. */
  public List<String> reading(String column) {
    return accessor.equals("value")
        ? List.of(JavaText.string(column), name + ".class")
        : List.of(JavaText.string(column));
  }

  /** A value as a Java expression. */
  String expression(Value value) {
    if (type instanceof DataType.Enumeration) {
      return name + "." + JavaNames.DECLARED.literal(value.literal());
    }
    if (!(type instanceof DataType.Scalar scalar)) {
      throw new IllegalArgumentException("a sequence has no literal: " + value.literal());
    }
    return switch (scalar.type()) {
      case INT8, UINT8, INT16, UINT16, INT32 -> cast() + value.literal();
      case UINT32, INT64 -> value.literal() + "L";
      case UINT64 -> "new BigInteger(" + JavaText.string(value.literal()) + ")";
      case FLOAT -> "(float) " + JavaText.real(((Value.Real) value).number());
      case DOUBLE -> JavaText.real(((Value.Real) value).number());
      case BOOLEAN -> value.literal();
      case CHAR -> JavaText.character(single(value.literal()));
      case STRING -> JavaText.string(value.literal());
      case VOID -> throw new IllegalArgumentException("void has no value");
    };
  }

  private String cast() {
    return name.equals("int") ? "" : "(" + name + ") ";
  }

  private static char single(String literal) {
    if (literal.length() != 1) {
      throw new IllegalArgumentException("'" + literal + "' is not a single character");
    }
    return literal.charAt(0);
  }

  private static boolean isPrimitive(JavaType element) {
    DataType inner = element.type;
    while (inner instanceof DataType.FixedArray array) {
      inner = array.element();
    }
    return inner instanceof DataType.Scalar scalar
        && scalar.type() != ScalarType.STRING
        && scalar.type() != ScalarType.UINT64;
  }

  private static JavaType array(JavaType element, DataType type, int length) {
    String name = element.name + "[]";
    boolean plain = element.type instanceof DataType.Scalar;
    String accessor =
        plain
            ? element.accessor.substring(0, element.accessor.length() - "Value".length()) + "Array"
            : "value";
    return new JavaType(name, name, accessor, empty(element, length), type, element.imports);
  }

  /**
   * An array of zeros: {@code new double[0]}, {@code new double[2][3]}, or with individual elements
   * for objects.
   */
  private static String empty(JavaType element, int length) {
    if (length > 0 && !isPrimitive(element)) {
      return "new "
          + element.name
          + "[] {"
          + String.join(", ", Collections.nCopies(length, element.zero))
          + "}";
    }
    int bracket = element.name.indexOf('[');
    String base = bracket < 0 ? element.name : element.name.substring(0, bracket);
    String inner = bracket < 0 ? "" : element.name.substring(bracket);
    if (length > 0 && element.type instanceof DataType.FixedArray) {
      inner = element.zero.substring(element.zero.indexOf('['));
    }
    return "new " + base + "[" + length + "]" + inner;
  }

  private static @Nullable JavaType scalar(DataType.Scalar type) {
    return switch (type.type()) {
      case VOID -> null;
      case BOOLEAN -> scalar("boolean", "Boolean", "false", type);
      case CHAR -> scalar("char", "Character", "'\\0'", type);
      case INT8 -> scalar("byte", "Byte", "(byte) 0", type);
      case UINT8, INT16 -> scalar("short", "Short", "(short) 0", type);
      case UINT16, INT32 -> scalar("int", "Integer", "0", type);
      case UINT32, INT64 -> scalar("long", "Long", "0L", type);
      case UINT64 ->
          new JavaType(
              "BigInteger",
              "BigInteger",
              "bigIntegerValue",
              "BigInteger.ZERO",
              type,
              Set.of("java.math.BigInteger"));
      case FLOAT -> scalar("float", "Float", "0.0f", type);
      case DOUBLE -> scalar("double", "Double", "0.0", type);
      case STRING -> new JavaType("String", "String", "stringValue", "\"\"", type, Set.of());
    };
  }

  private static JavaType scalar(String name, String boxed, String zero, DataType type) {
    return new JavaType(name, boxed, name + "Value", zero, type, Set.of());
  }
}
