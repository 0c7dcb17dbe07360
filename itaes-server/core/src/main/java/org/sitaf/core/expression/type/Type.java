package org.sitaf.core.expression.type;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;

/** The type of an expression, as far as it is known before the evaluation. */
public sealed interface Type {
  /** Not known before the evaluation. */
  Type ANY = new Simple("any");

  /** The type of the elements of an empty list. */
  Type NOTHING = new Simple("nothing");

  /** A whole number. */
  Type WHOLE = new Simple("int");

  /** A floating-point number. */
  Type REAL = new Simple("double");

  /** A boolean. */
  Type BOOLEAN = new Simple("bool");

  /** A string, a character or the literal of an enumeration. */
  Type TEXT = new Simple("string");

  /** {@code null}, the value of a method that returns nothing. */
  Type NULL = new Simple("null");

  /** A string such as {@code "!error:NAME"} or {@code "!any"}, which fits to any other type. */
  Type OUTCOME = new Simple("outcome");

  /** The name for messages. */
  String name();

  /** A type without parts. */
  record Simple(String name) implements Type {}

  /** A list. */
  record Sequence(Type element) implements Type {
    public Sequence {
      Objects.requireNonNull(element);
    }

    @Override
    public String name() {
      return "list(" + element.name() + ")";
    }
  }

  /** A map whose keys are not known. */
  record Mapping(Type value) implements Type {
    public Mapping {
      Objects.requireNonNull(value);
    }

    @Override
    public String name() {
      return "map";
    }
  }

  /**
   * A struct, or a map whose keys are known.
   *
   * @param struct name of the type; empty for a map
   */
  record Members(String struct, Map<String, Type> members) implements Type {
    public Members {
      Objects.requireNonNull(struct);
      members = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(members));
    }

    @Override
    public String name() {
      return struct.isEmpty() ? "{" + String.join(", ", members.keySet()) + "}" : struct;
    }
  }

  /** The type of a value of an interface. */
  static Type of(DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      if (scalar.type().isInteger()) {
        return WHOLE;
      }
      if (scalar.type().isFloating()) {
        return REAL;
      }
      return scalar.type() == ScalarType.BOOLEAN
          ? BOOLEAN
          : scalar.type() == ScalarType.VOID ? ANY : TEXT;
    }
    if (type instanceof DataType.Enumeration) {
      return TEXT;
    }
    if (type instanceof DataType.Sequence sequence) {
      return new Sequence(of(sequence.element()));
    }
    if (type instanceof DataType.FixedArray array) {
      return new Sequence(of(array.element()));
    }
    if (type instanceof DataType.Struct struct) {
      Map<String, Type> members = new LinkedHashMap<>();
      struct.members().forEach(m -> members.put(m.name(), of(m.type())));
      return new Members(struct.name(), members);
    }
    return ANY;
  }

  /** Whether the type is or may be a number. */
  default boolean mayBeNumber() {
    return equals(WHOLE) || equals(REAL) || isOpen();
  }

  /** Whether nothing is known about the values. */
  default boolean isOpen() {
    return equals(ANY) || equals(NOTHING);
  }

  /**
   * The type of a value that has either of two types. A whole number next to a floating-point
   * number is one.
   *
   * @return null if they have nothing in common
   */
  static @Nullable Type join(Type a, Type b) {
    if (a.equals(b) || b.equals(NOTHING) || b.equals(OUTCOME) || b.equals(NULL)) {
      return a.equals(NOTHING) || a.equals(OUTCOME) || a.equals(NULL) ? b : a;
    }
    if (a.equals(NOTHING) || a.equals(OUTCOME) || a.equals(NULL)) {
      return b;
    }
    if (a.equals(ANY) || b.equals(ANY)) {
      return ANY;
    }
    if (a.mayBeNumber() && b.mayBeNumber()) {
      return REAL;
    }
    if (a instanceof Sequence first && b instanceof Sequence second) {
      Type element = join(first.element, second.element);
      return element == null ? null : new Sequence(element);
    }
    if (a instanceof Members first && b instanceof Members second) {
      return join(first, second);
    }
    return (a instanceof Members || a instanceof Mapping)
            && (b instanceof Members || b instanceof Mapping)
        ? new Mapping(ANY)
        : null;
  }

  private static @Nullable Type join(Members a, Members b) {
    Map<String, Type> members = new LinkedHashMap<>(a.members);
    for (Map.Entry<String, Type> member : b.members.entrySet()) {
      Type known = members.get(member.getKey());
      Type joined = known == null ? member.getValue() : join(known, member.getValue());
      if (joined == null) {
        return null;
      }
      members.put(member.getKey(), joined);
    }
    return new Members(a.struct.isEmpty() ? b.struct : a.struct, members);
  }
}
