package org.sitaf.core.expression.type;

import java.util.List;
import org.sitaf.core.expression.function.Signature;

/** What a parameter of a function takes, by type. */
final class Kinds {
  private Kinds() {}

  /** Whether a value of the type may be an argument. */
  static boolean fits(Type type, Signature.Kind kind) {
    if (type.isOpen()) {
      return true;
    }
    return switch (kind) {
      case NUMBER -> type.mayBeNumber();
      case WHOLE -> type.equals(Type.WHOLE);
      case LIST -> type instanceof Type.Sequence sequence && sequence.element().mayBeNumber();
      case VECTOR -> isVector(type);
      case MATRIX ->
          type instanceof Type.Sequence rows
              && (rows.element().isOpen() || isVector(rows.element()));
      case QUATERNION -> hasNumbers(type, List.of("x", "y", "z", "w"));
      case VALUE -> true;
    };
  }

  /** The type of a number, or of the numbers in a vector. */
  static Type number(Type type) {
    if (type instanceof Type.Sequence sequence) {
      return sequence.element().isOpen() ? Type.ANY : sequence.element();
    }
    if (type instanceof Type.Members struct) {
      return struct.members().values().stream().allMatch(Type.WHOLE::equals)
          ? Type.WHOLE
          : Type.REAL;
    }
    return type.isOpen() ? Type.ANY : type;
  }

  private static boolean isVector(Type type) {
    if (type instanceof Type.Sequence sequence) {
      return sequence.element().mayBeNumber();
    }
    return hasNumbers(type, List.of("x", "y", "z"))
        && !(type instanceof Type.Members struct && struct.members().containsKey("w"));
  }

  private static boolean hasNumbers(Type type, List<String> members) {
    if (type instanceof Type.Members struct) {
      return members.stream()
          .allMatch(m -> struct.members().containsKey(m) && struct.members().get(m).mayBeNumber());
    }
    return type instanceof Type.Mapping;
  }
}
