package org.sitaf.core.harness.java.plan;

import java.util.Optional;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Value;

/**
 * How Java spells a type of an interface: integers by width, unsigned ones in the next wider type
 * (the widest in {@code BigInteger}), sequences and arrays of these in Java arrays. Structs,
 * enumerations and nested sequences have no spelling yet.
 *
 * @param name in declarations
 * @param boxed as a type argument
 * @param accessor of the runtime's {@code TestCase} that reads it
 * @param zero the value that nobody has set
 * @param scalar null for a sequence
 */
public record JavaType(
    String name,
    String boxed,
    String accessor,
    String zero,
    @org.jspecify.annotations.Nullable ScalarType scalar) {

  /** What is said where a type has no spelling. */
  static final String SUPPORTED =
      "a Java test application knows boolean, char, string, integers, float, double, and sequences of these";

  /** The type in Java; empty where there is none. {@code void} is none. */
  static Optional<JavaType> of(DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      return scalar(scalar.type());
    }
    if (type instanceof DataType.Sequence sequence) {
      return array(sequence.element());
    }
    if (type instanceof DataType.FixedArray fixed) {
      return array(fixed.element());
    }
    return Optional.empty();
  }

  /** A value as an expression of this type. */
  String expression(Value value) {
    if (scalar == null) {
      throw new IllegalArgumentException("a sequence has no literal: " + value.literal());
    }
    return switch (scalar) {
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

  private static Optional<JavaType> array(DataType element) {
    return element instanceof DataType.Scalar scalar
        ? scalar(scalar.type()).map(JavaType::toArray)
        : Optional.empty();
  }

  private JavaType toArray() {
    String array = name + "[]";
    String reader = accessor.substring(0, accessor.length() - "Value".length()) + "Array";
    return new JavaType(array, array, reader, "new " + name + "[0]", null);
  }

  private static Optional<JavaType> scalar(ScalarType type) {
    return Optional.ofNullable(
        switch (type) {
          case VOID -> null;
          case BOOLEAN -> new JavaType("boolean", "Boolean", "booleanValue", "false", type);
          case CHAR -> new JavaType("char", "Character", "charValue", "'\\0'", type);
          case INT8 -> new JavaType("byte", "Byte", "byteValue", "(byte) 0", type);
          case UINT8, INT16 -> new JavaType("short", "Short", "shortValue", "(short) 0", type);
          case UINT16, INT32 -> new JavaType("int", "Integer", "intValue", "0", type);
          case UINT32, INT64 -> new JavaType("long", "Long", "longValue", "0L", type);
          case UINT64 ->
              new JavaType("BigInteger", "BigInteger", "bigIntegerValue", "BigInteger.ZERO", type);
          case FLOAT -> new JavaType("float", "Float", "floatValue", "0.0f", type);
          case DOUBLE -> new JavaType("double", "Double", "doubleValue", "0.0", type);
          case STRING -> new JavaType("String", "String", "stringValue", "\"\"", type);
        });
  }
}
