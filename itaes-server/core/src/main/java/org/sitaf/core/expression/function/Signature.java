package org.sitaf.core.expression.function;

import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;

/**
 * The parameters and the result of a function.
 *
 * @param cost how the work grows with the arguments
 */
public record Signature(String name, List<Kind> parameters, Result result, Cost cost) {
  public Signature {
    Objects.requireNonNull(name);
    parameters = List.copyOf(parameters);
    Objects.requireNonNull(result);
    Objects.requireNonNull(cost);
  }

  /** What a parameter takes. */
  public enum Kind {
    /** A number. */
    NUMBER("a number"),
    /** A whole number. */
    WHOLE("a whole number"),
    /** A list of numbers; two or more arguments are one list. */
    LIST("two or more numbers or one list of numbers"),
    /** A list of numbers, or a struct with x, y and z. */
    VECTOR("a list of numbers or a struct with x, y and z"),
    /** A list of rows. */
    MATRIX("a list of rows"),
    /** A struct with x, y, z and w. */
    QUATERNION("a struct with x, y, z and w"),
    /** Any value. */
    VALUE("a value");

    private final String text;

    Kind(String text) {
      this.text = text;
    }

    /** A description for messages. */
    public String text() {
      return text;
    }
  }

  /** The type of the result. */
  public enum Result {
    /** A floating-point number. */
    REAL,
    /** A boolean. */
    BOOLEAN,
    /** A number: whole if all arguments are whole. */
    SAME,
    /** As the first argument. */
    FORM,
    /** As the last argument. */
    LAST_FORM,
    /** A list of rows of floating-point numbers. */
    MATRIX
  }

  /** How the work grows with the arguments. */
  public enum Cost {
    /** Not at all. */
    CONSTANT,
    /** With the number of parts of arguments and result. */
    PARTS,
    /** With the product of the number of cells and the longer side of a matrix. */
    PRODUCT
  }

  /** The signature for messages, such as {@code pow(number, number)}. */
  public String text() {
    return name
        + parameters.stream()
            .map(p -> p.name().toLowerCase(java.util.Locale.ROOT))
            .collect(Collectors.joining(", ", "(", ")"));
  }
}
