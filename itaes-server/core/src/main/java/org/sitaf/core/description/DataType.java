package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;

/** A resolved data type of an interface. */
public sealed interface DataType {

  /** The canonical name, such as {@code int32}, {@code sequence<double>} or {@code Pose}. */
  String typeName();

  /** The direct component types: elements or members. */
  default List<DataType> parts() {
    return List.of();
  }

  /** Whether a method of this return type returns nothing. */
  default boolean isVoid() {
    return this instanceof Scalar scalar && scalar.type() == ScalarType.VOID;
  }

  /** Whether it, or a type that it contains, is not defined. */
  default boolean holdsUnknown() {
    return this instanceof Unknown || parts().stream().anyMatch(DataType::holdsUnknown);
  }

  /** The type of a member; {@link Unknown} if there is no such member. */
  default DataType member(String name) {
    return new Unknown("");
  }

  /**
   * A scalar type.
   *
   * @param bound maximum length of a string; 0 if unbounded
   */
  record Scalar(ScalarType type, int bound) implements DataType {
    public Scalar {
      Objects.requireNonNull(type);
      if (bound < 0 || (bound > 0 && type != ScalarType.STRING)) {
        throw new IllegalArgumentException("a " + type.typeName() + " has no bound " + bound);
      }
    }

    /** A scalar without a bound. */
    public Scalar(ScalarType type) {
      this(type, 0);
    }

    @Override
    public String typeName() {
      return bound == 0 ? type.typeName() : type.typeName() + "<" + bound + ">";
    }
  }

  /**
   * A sequence of elements of one type: vector, valarray, sequence, list.
   *
   * @param bound maximum number of elements; 0 if unbounded
   */
  record Sequence(DataType element, int bound) implements DataType {
    public Sequence {
      Objects.requireNonNull(element);
      if (bound < 0) {
        throw new IllegalArgumentException("a sequence has no bound " + bound);
      }
    }

    /** An unbounded sequence. */
    public Sequence(DataType element) {
      this(element, 0);
    }

    @Override
    public List<DataType> parts() {
      return List.of(element);
    }

    @Override
    public String typeName() {
      return "sequence<" + element.typeName() + (bound == 0 ? ">" : "," + bound + ">");
    }
  }

  /**
   * An array of fixed length. As in C++, {@code double[2][3]} is an array of two arrays of three.
   */
  record FixedArray(DataType element, int length) implements DataType {
    public FixedArray {
      Objects.requireNonNull(element);
      if (length < 1) {
        throw new IllegalArgumentException("an array has at least one element: " + length);
      }
    }

    @Override
    public List<DataType> parts() {
      return List.of(element);
    }

    @Override
    public String typeName() {
      StringBuilder dimensions = new StringBuilder("[" + length + "]");
      DataType inner = element;
      while (inner instanceof FixedArray array) {
        dimensions.append('[').append(array.length).append(']');
        inner = array.element;
      }
      return inner.typeName() + dimensions;
    }
  }

  /** A struct with named members. */
  record Struct(String name, List<Member> members) implements DataType {
    public Struct {
      Objects.requireNonNull(name);
      members = List.copyOf(members);
    }

    @Override
    public List<DataType> parts() {
      return members.stream().map(Member::type).toList();
    }

    @Override
    public DataType member(String wanted) {
      return members.stream()
          .filter(member -> member.name().equals(wanted))
          .map(Member::type)
          .findFirst()
          .orElse(new Unknown(""));
    }

    @Override
    public String typeName() {
      return name;
    }
  }

  /** A member of a struct. */
  record Member(String name, DataType type) {
    public Member {
      Objects.requireNonNull(name);
      Objects.requireNonNull(type);
    }
  }

  /** An enumeration with named literals. */
  record Enumeration(String name, List<String> literals) implements DataType {
    public Enumeration {
      Objects.requireNonNull(name);
      literals = List.copyOf(literals);
    }

    @Override
    public String typeName() {
      return name;
    }
  }

  /**
   * A type that none of the given files defines. It keeps its name and is reported as a warning.
   */
  record Unknown(String name) implements DataType {
    public Unknown {
      Objects.requireNonNull(name);
    }

    @Override
    public String typeName() {
      return name;
    }
  }
}
