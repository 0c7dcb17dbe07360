package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;

/** A type of an interface, resolved from its spelling. */
public sealed interface DataType {

  /** The canonical spelling, such as {@code int32}, {@code sequence<double>} or {@code Pose}. */
  String spelling();

  /** A type without parts. */
  record Scalar(ScalarType type) implements DataType {
    public Scalar {
      Objects.requireNonNull(type);
    }

    @Override
    public String spelling() {
      return type.spelling();
    }
  }

  /** Any number of elements: vector, valarray, sequence, list. */
  record Sequence(DataType element) implements DataType {
    public Sequence {
      Objects.requireNonNull(element);
    }

    @Override
    public String spelling() {
      return "sequence<" + element.spelling() + ">";
    }
  }

  /** A fixed number of elements. */
  record FixedArray(DataType element, int length) implements DataType {
    public FixedArray {
      Objects.requireNonNull(element);
      if (length < 1) {
        throw new IllegalArgumentException("an array has at least one element: " + length);
      }
    }

    @Override
    public String spelling() {
      return element.spelling() + "[" + length + "]";
    }
  }

  /** Named members. */
  record Struct(String name, List<Member> members) implements DataType {
    public Struct {
      Objects.requireNonNull(name);
      members = List.copyOf(members);
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
