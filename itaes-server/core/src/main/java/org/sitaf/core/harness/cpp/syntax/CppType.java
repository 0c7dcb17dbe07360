package org.sitaf.core.harness.cpp.syntax;

import java.util.Objects;
import java.util.SortedSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Value;

/**
 * The C++ types of interface types: sequences are vectors, structs and enumerations are declared in
 * {@code sitaf::interfaces}.
 */
public final class CppType {
  private CppType() {}

  /** The name of a type in test applications. */
  public static String of(DataType type) {
    return typeName(type, "interfaces::");
  }

  /** The name of a type in the interfaces. */
  public static String within(DataType type) {
    return typeName(type, "");
  }

  /** The name of a type in components. */
  public static String outside(DataType type) {
    return typeName(type, "sitaf::interfaces::");
  }

  private static String typeName(DataType type, String scope) {
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case VOID -> "void";
        case BOOLEAN -> "bool";
        case CHAR -> "char";
        case FLOAT -> "float";
        case DOUBLE -> "double";
        case STRING -> "std::string";
        default -> "std::" + scalar.type().typeName() + "_t";
      };
    }
    if (type instanceof DataType.Sequence sequence) {
      return "std::vector<" + typeName(sequence.element(), scope) + ">";
    }
    if (type instanceof DataType.FixedArray array) {
      return "std::array<" + typeName(array.element(), scope) + ", " + array.length() + ">";
    }
    return scope + CppNames.DECLARED.type(type);
  }

  /** A parameter of a function: simple values are passed by value, others by reference. */
  public static String parameter(Parameter parameter, String name, boolean within) {
    return parameter(parameter, name, within ? within(parameter.type()) : of(parameter.type()));
  }

  /** A parameter of a function in components. */
  public static String outsideParameter(Parameter parameter, String name) {
    return parameter(parameter, name, outside(parameter.type()));
  }

  private static String parameter(Parameter parameter, String name, String type) {
    if (parameter.direction() != Direction.IN) {
      return type + "& " + name;
    }
    return isSingle(parameter.type()) ? type + " " + name : "const " + type + "& " + name;
  }

  /** Whether values of the type are passed by value. */
  public static boolean isSingle(DataType type) {
    return type instanceof DataType.Enumeration
        || (type instanceof DataType.Scalar scalar && scalar.type() != ScalarType.STRING);
  }

  /** Adds the headers of a type. */
  public static void addHeaders(DataType type, SortedSet<String> standard, SortedSet<String> own) {
    if (type instanceof DataType.Scalar scalar) {
      if (scalar.type().isInteger()) {
        standard.add("cstdint");
      } else if (scalar.type() == ScalarType.STRING) {
        standard.add("string");
      }
    } else if (type instanceof DataType.Sequence sequence) {
      standard.add("vector");
      addHeaders(sequence.element(), standard, own);
    } else if (type instanceof DataType.FixedArray array) {
      standard.add("array");
      addHeaders(array.element(), standard, own);
    } else {
      own.add("sitaf/interfaces/" + CppNames.DECLARED.type(type) + ".hpp");
    }
  }

  /**
   * A value as an expression.
   *
   * @throws IllegalArgumentException if C++ cannot represent it
   */
  public static String expression(Value value, DataType type) {
    if (type instanceof DataType.Enumeration) {
      return of(type) + "::" + CppNames.DECLARED.literal(value.literal());
    }
    ScalarType scalar = ((DataType.Scalar) Objects.requireNonNull(type)).type();
    return switch (scalar) {
      case BOOLEAN -> value.literal();
      case CHAR -> CppText.character(value.literal().charAt(0));
      case STRING -> CppText.string(value.literal());
      case DOUBLE -> CppText.real(((Value.Real) value).number());
      case FLOAT -> "static_cast<float>(" + CppText.real(((Value.Real) value).number()) + ")";
      case INT32 ->
          value.literal().equals("-2147483648") ? "std::int32_t{-2147483647 - 1}" : value.literal();
      case INT64 ->
          value.literal().equals("-9223372036854775808")
              ? "std::int64_t{-9223372036854775807 - 1}"
              : "std::int64_t{" + value.literal() + "}";
      case UINT64 -> "std::uint64_t{" + value.literal() + "U}";
      case INT8, UINT8, INT16, UINT16, UINT32 -> of(type) + "{" + value.literal() + "}";
      case VOID -> throw new IllegalArgumentException("void has no value");
    };
  }
}
