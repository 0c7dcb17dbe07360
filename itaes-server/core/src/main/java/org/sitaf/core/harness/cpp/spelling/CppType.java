package org.sitaf.core.harness.cpp.spelling;

import java.util.Objects;
import java.util.SortedSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.model.Value;

/**
 * How C++ spells a type of an interface: integers by width, sequences as vectors, arrays as arrays,
 * structs and enumerations by their names in {@code sitaf::interfaces}.
 */
public final class CppType {
  private CppType() {}

  /** The type as test applications write it. */
  public static String of(DataType type) {
    return spell(type, "interfaces::");
  }

  /** The type as the interfaces themselves write it. */
  public static String within(DataType type) {
    return spell(type, "");
  }

  /** The type as components write it. */
  public static String outside(DataType type) {
    return spell(type, "sitaf::interfaces::");
  }

  private static String spell(DataType type, String scope) {
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case VOID -> "void";
        case BOOLEAN -> "bool";
        case CHAR -> "char";
        case FLOAT -> "float";
        case DOUBLE -> "double";
        case STRING -> "std::string";
        default -> "std::" + scalar.type().spelling() + "_t";
      };
    }
    if (type instanceof DataType.Sequence sequence) {
      return "std::vector<" + spell(sequence.element(), scope) + ">";
    }
    if (type instanceof DataType.FixedArray array) {
      return "std::array<" + spell(array.element(), scope) + ", " + array.length() + ">";
    }
    return scope + HarnessPlan.simpleName(type);
  }

  /** A parameter of a function: single values as they are, others by reference. */
  public static String parameter(Parameter parameter, String name, boolean within) {
    return parameter(parameter, name, within ? within(parameter.type()) : of(parameter.type()));
  }

  /** A parameter of a function, as components write it. */
  public static String outsideParameter(Parameter parameter, String name) {
    return parameter(parameter, name, outside(parameter.type()));
  }

  private static String parameter(Parameter parameter, String name, String type) {
    if (parameter.direction() != Direction.IN) {
      return type + "& " + name;
    }
    return isSingle(parameter.type()) ? type + " " + name : "const " + type + "& " + name;
  }

  /** Whether a value of the type is no dearer than a reference to it. */
  public static boolean isSingle(DataType type) {
    return type instanceof DataType.Enumeration
        || (type instanceof DataType.Scalar scalar && scalar.type() != ScalarType.STRING);
  }

  /** Adds the headers that a type needs, as they stand between the brackets of an include. */
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
      own.add("sitaf/interfaces/" + HarnessPlan.simpleName(type) + ".hpp");
    }
  }

  /**
   * A value as an expression.
   *
   * @throws IllegalArgumentException when C++ cannot hold it
   */
  public static String expression(Value value, DataType type) {
    if (type instanceof DataType.Enumeration) {
      return of(type) + "::" + value.literal();
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
