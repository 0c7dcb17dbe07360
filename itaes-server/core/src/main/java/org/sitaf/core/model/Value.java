package org.sitaf.core.model;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Objects;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;

/** A value of a test element; its literal is what documents hold. */
public sealed interface Value {

  /** Begins an error that is thrown or expected where a value could be: {@code !error:NoEcho}. */
  String MARK_OF_ERROR = "!error:";

  /** Begins a delay of an answer of the test stub: {@code !delay:0.5}, in seconds. */
  String MARK_OF_DELAY = "!delay:";

  /** The spelling in documents: {@code 7}, {@code 9.5}, {@code true}, or the text itself. */
  String literal();

  /** A whole number. */
  record Whole(BigInteger number) implements Value {
    public Whole {
      Objects.requireNonNull(number);
    }

    @Override
    public String literal() {
      return number.toString();
    }
  }

  /** A floating-point number, NaN and infinities among them. */
  record Real(double number) implements Value {
    @Override
    public String literal() {
      return Double.toString(number);
    }
  }

  /** A boolean. */
  record Truth(boolean value) implements Value {
    @Override
    public String literal() {
      return Boolean.toString(value);
    }
  }

  /**
   * A string, a character, the literal of an enumeration, or the spelling of a value whose type is
   * unknown.
   */
  record Text(String text) implements Value {
    public Text {
      Objects.requireNonNull(text);
    }

    @Override
    public String literal() {
      return text;
    }
  }

  /**
   * Reads an answer of the test stub: a value of its type, an error or a delay.
   *
   * @throws IllegalArgumentException when it is neither; the message says what was expected
   */
  static Value parseAnswer(String literal, DataType type) {
    return isErrorOrDelay(literal) ? new Text(literal) : parse(literal, type);
  }

  /** Whether an answer of the test stub is more than a value of its type. */
  static boolean isErrorOrDelay(String literal) {
    return literal.startsWith(MARK_OF_ERROR) || literal.startsWith(MARK_OF_DELAY);
  }

  /**
   * Reads a literal as a value of a type.
   *
   * @throws IllegalArgumentException when the type cannot hold it; the message says what was
   *     expected
   */
  static Value parse(String literal, DataType type) {
    if (!(type instanceof DataType.Scalar scalar)) {
      return new Text(literal);
    }
    ScalarType kind = scalar.type();
    if (kind.isInteger()) {
      return wholeOf(literal.strip(), kind);
    }
    if (kind.isFloating()) {
      return new Real(realOf(literal.strip(), kind));
    }
    if (kind == ScalarType.BOOLEAN) {
      return switch (literal.strip()) {
        case "true", "1" -> new Truth(true);
        case "false", "0" -> new Truth(false);
        default -> throw new IllegalArgumentException("'" + literal + "' is not true or false");
      };
    }
    return new Text(literal);
  }

  private static Whole wholeOf(String literal, ScalarType kind) {
    BigInteger number;
    try {
      number = Decimals.parse(literal).toBigIntegerExact();
    } catch (IllegalArgumentException | ArithmeticException e) {
      throw new IllegalArgumentException("'" + literal + "' is not a whole number", e);
    }
    if (number.compareTo(Objects.requireNonNull(kind.minimum())) < 0
        || number.compareTo(Objects.requireNonNull(kind.maximum())) > 0) {
      throw new IllegalArgumentException(
          literal
              + " does not fit into "
              + kind.spelling()
              + " ("
              + kind.minimum()
              + " to "
              + kind.maximum()
              + ")");
    }
    return new Whole(number);
  }

  private static double realOf(String literal, ScalarType kind) {
    double number =
        switch (literal) {
          case "NaN", "nan", ".nan" -> Double.NaN;
          case "Infinity", "+Infinity", "inf", "+inf", ".inf" -> Double.POSITIVE_INFINITY;
          case "-Infinity", "-inf", "-.inf" -> Double.NEGATIVE_INFINITY;
          default -> inRange(Decimals.parse(literal), kind);
        };
    return literal.startsWith("-") && number == 0 ? -0.0 : number;
  }

  private static double inRange(BigDecimal decimal, ScalarType kind) {
    double number = decimal.doubleValue();
    double narrowed = kind == ScalarType.FLOAT ? decimal.floatValue() : number;
    if (Double.isInfinite(narrowed)) {
      throw new IllegalArgumentException(decimal + " does not fit into " + kind.spelling());
    }
    return number;
  }
}
