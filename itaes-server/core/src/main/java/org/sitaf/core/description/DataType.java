package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;

/** A type of an interface, resolved from its spelling. */
public sealed interface DataType {

  /** The canonical spelling, such as {@code int32}, {@code sequence<double>} or {@code Pose}. */
  String spelling();

  /** The types that this one is made of, one level down. */
  default List<DataType> parts() {
    return List.of();
  }

  /** The type of a member of this name; unknown where there is no such member. */
  default DataType member(String name) {
    return new Unknown("");
  }

  /**
   * A type without parts.
   *
   * @param bound greatest length of a string; 0 where any length is allowed
   */
  record Scalar(ScalarType type, int bound) implements DataType {
    public Scalar {
      Objects.requireNonNull(type);
      if (bound < 0 || (bound > 0 && type != ScalarType.STRING)) {
        throw new IllegalArgumentException("a " + type.spelling() + " has no bound " + bound);
      }
    }

    /** A type without parts and without a bound. */
    public Scalar(ScalarType type) {
      this(type, 0);
    }

    @Override
    public String spelling() {
      return bound == 0 ? type.spelling() : type.spelling() + "<" + bound + ">";
    }
  }

  /**
   * Elements of one type: vector, valarray, sequence, list.
   *
   * @param bound greatest number of elements; 0 where any number is allowed
   */
  record Sequence(DataType element, int bound) implements DataType {
    public Sequence {
      Objects.requireNonNull(element);
      if (bound < 0) {
        throw new IllegalArgumentException("a sequence has no bound " + bound);
      }
    }

    /** Any number of elements. */
    public Sequence(DataType element) {
      this(element, 0);
    }

    @Override
    public List<DataType> parts() {
      return List.of(element);
    }

    @Override
    public String spelling() {
      return "sequence<" + element.spelling() + (bound == 0 ? ">" : "," + bound + ">");
    }
  }

  /** A fixed number of elements; {@code double[2][3]} is two times three of them, as in C++. */
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
    public String spelling() {
      StringBuilder dimensions = new StringBuilder("[" + length + "]");
      DataType inner = element;
      while (inner instanceof FixedArray array) {
        dimensions.append('[').append(array.length).append(']');
        inner = array.element;
      }
      return inner.spelling() + dimensions;
    }
  }

  /** Named members. */
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
    public String spelling() {
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

  /** Named literals. */
  record Enumeration(String name, List<String> literals) implements DataType {
    public Enumeration {
      Objects.requireNonNull(name);
      literals = List.copyOf(literals);
    }

    @Override
    public String spelling() {
      return name;
    }
  }

  /** A type that nothing at hand defines; kept by its name and reported. */
  record Unknown(String name) implements DataType {
    public Unknown {
      Objects.requireNonNull(name);
    }

    @Override
    public String spelling() {
      return name;
    }
  }
}
