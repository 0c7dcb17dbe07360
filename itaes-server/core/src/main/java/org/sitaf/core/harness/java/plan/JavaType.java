package org.sitaf.core.harness.java.plan;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.model.Value;

/**
 * How Java spells a type of an interface: integers by width, unsigned ones in the next wider type
 * (the widest in {@code BigInteger}), sequences and arrays as Java arrays, structs as generated
 * records, enumerations as generated enums.
 *
 * @param name in declarations
 * @param boxed as a type argument
 * @param accessor of the runtime's {@code TestCase} that reads it
 * @param zero the value that nobody has set
 * @param type that it spells
 * @param imports what a source needs that names it
 */
public record JavaType(
    String name, String boxed, String accessor, String zero, DataType type, Set<String> imports) {
  /** Where generated interfaces and types lie. */
  public static final String INTERFACES = "sitaf.interfaces";

  /** What is said where a type has no spelling. */
  static final String SUPPORTED = "a Java test application knows no such type";

  /** Elements of a fixed array that are written out one by one. */
  private static final int MAX_WRITTEN = 64;

  public JavaType {
    imports = Set.copyOf(imports);
  }

  /** The type in Java; empty where there is none. {@code void} is none. */
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
      String name = HarnessPlan.simpleName(type);
      String zero =
          type instanceof DataType.Enumeration enumeration
              ? name + "." + enumeration.literals().get(0)
              : "new " + name + "()";
      return Optional.of(
          new JavaType(name, name, "value", zero, type, Set.of(INTERFACES + "." + name)));
    }
    return Optional.empty();
  }

  /** What a case's value of this type is read with. */
  public List<String> reading(String column) {
    return accessor.equals("value")
        ? List.of(JavaText.string(column), name + ".class")
        : List.of(JavaText.string(column));
  }

  /** A value as an expression of this type. */
  String expression(Value value) {
    if (type instanceof DataType.Enumeration) {
      return name + "." + value.literal();
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
      throw new IllegalArgumentException("'" + literal + "' is not one character");
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
   * An array of zeros: {@code new double[0]}, {@code new double[2][3]}, written out for objects.
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
