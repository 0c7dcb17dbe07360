package org.sitaf.core.harness.python;

import java.util.Set;
import java.util.TreeSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Value;

/** The Python types of interface types. */
final class PythonType {
  private static final String KINDS = "sitaf_runtime.suite.kinds";

  private PythonType() {}

  /** The type annotation. */
  static String hint(DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case VOID -> "None";
        case BOOLEAN -> "bool";
        case CHAR, STRING -> "str";
        case FLOAT, DOUBLE -> "float";
        default -> "int";
      };
    }
    if (type instanceof DataType.Sequence sequence) {
      return "list[" + hint(sequence.element()) + "]";
    }
    if (type instanceof DataType.FixedArray array) {
      return "list[" + hint(array.element()) + "]";
    }
    return PythonNames.DECLARED.type(type);
  }

  /** The zero value as an expression. */
  static String zero(DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case VOID -> "None";
        case BOOLEAN -> "False";
        case CHAR -> "\"\\0\"";
        case STRING -> "\"\"";
        case FLOAT, DOUBLE -> "0.0";
        default -> "0";
      };
    }
    if (type instanceof DataType.Sequence) {
      return "[]";
    }
    if (type instanceof DataType.FixedArray array) {
      return "[" + zero(array.element()) + " for _ in range(" + array.length() + ")]";
    }
    if (type instanceof DataType.Enumeration enumeration) {
      return PythonNames.DECLARED.type(type)
          + "."
          + PythonNames.DECLARED.literal(enumeration.literals().get(0));
    }
    return PythonNames.DECLARED.type(type) + "()";
  }

  /** The runtime's kind of a type, which reads and compares its values. */
  static String kind(DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      return kind(scalar.type());
    }
    if (type instanceof DataType.Sequence sequence) {
      return "sequence(" + kind(sequence.element()) + ")";
    }
    if (type instanceof DataType.FixedArray array) {
      return "sequence(" + kind(array.element()) + ", " + array.length() + ")";
    }
    String function = type instanceof DataType.Enumeration ? "enumeration" : "struct";
    return function + "(" + PythonNames.DECLARED.type(type) + ")";
  }

  private static String kind(ScalarType type) {
    return switch (type) {
      case VOID -> "None";
      case CHAR -> "CHARACTER";
      case FLOAT -> "FLOAT32";
      case DOUBLE -> "FLOAT64";
      default -> type.name();
    };
  }

  /** Adds the imports of {@link #kind}. */
  static void importKind(DataType type, Imports imports) {
    for (String word : kind(type).split("\\W+")) {
      if (PythonNames.isUsedType(word)) {
        imports.add(KINDS, word);
      }
    }
    importHint(type, imports);
  }

  /** Adds the imports of {@link #hint}. */
  static void importHint(DataType type, Imports imports) {
    declared(type).forEach(name -> imports.add("sitaf_interfaces", name));
  }

  /** The structs and enumerations in the annotation of a type. */
  private static Set<String> declared(DataType type) {
    Set<String> names = new TreeSet<>();
    if (type instanceof DataType.Struct || type instanceof DataType.Enumeration) {
      names.add(PythonNames.DECLARED.type(type));
    } else {
      type.parts().forEach(part -> names.addAll(declared(part)));
    }
    return names;
  }

  /** A value as an expression. */
  static String expression(Value value, DataType type) {
    if (type instanceof DataType.Enumeration) {
      return PythonNames.DECLARED.type(type) + "." + PythonNames.DECLARED.literal(value.literal());
    }
    if (value instanceof Value.Real real) {
      return PythonText.real(real.number());
    }
    if (value instanceof Value.Bool bool) {
      return bool.value() ? "True" : "False";
    }
    return value instanceof Value.Whole ? value.literal() : PythonText.string(value.literal());
  }
}
