package org.sitaf.core.model;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Objects;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;

/** A value of a test element. */
public sealed interface Value {

  /** Prefix of an error that is thrown or expected instead of a value: {@code !error:NoEcho}. */
  String ERROR_PREFIX = "!error:";

  /** Expects any error instead of a value. */
  String ANY_ERROR = "!error";

  /** Expects nothing: neither a value nor an error is judged. */
  String ANY = "!any";

  /** Prefix of a delay of a test stub's answer, in seconds: {@code !delay:0.5}. */
  String DELAY_PREFIX = "!delay:";

  /**
   * The value as written in documents: {@code 7}, {@code 9.5}, {@code true}, or the text itself.
   */
  String literal();

  /** An integer. */
  record Whole(BigInteger number) implements Value {
    public Whole {
      Objects.requireNonNull(number);
    }

    @Override
    public String literal() {
      return number.toString();
    }
  }

  /** A floating-point number, possibly NaN or infinite. */
  record Real(double number) implements Value {
    @Override
    public String literal() {
      return Double.toString(number);
    }
  }

  /** A boolean. */
  record Bool(boolean value) implements Value {
    @Override
    public String literal() {
      return Boolean.toString(value);
    }
  }

  /**
   * A string, a character, an enumeration literal, or the literal of a value of a structured or
   * unknown type.
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
   * Parses an answer of a test stub: a value of the type, an error or a delay.
   *
   * @throws IllegalArgumentException if it is none of these
   */
  static Value parseAnswer(String literal, DataType type) {
    return isErrorOrDelay(literal) ? new Text(literal) : parse(literal, type);
  }

  /** Whether a literal is an error or a delay instead of a value. */
  static boolean isErrorOrDelay(String literal) {
    return literal.startsWith(ERROR_PREFIX) || literal.startsWith(DELAY_PREFIX);
  }

  /** Whether an expected literal is an outcome instead of a value. */
  static boolean isOutcome(String literal) {
    return literal.startsWith(ERROR_PREFIX) || literal.equals(ANY_ERROR) || literal.equals(ANY);
  }

  /**
   * Parses a literal.
   *
   * @throws IllegalArgumentException if it is not a value of the type
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
        case "true", "1" -> new Bool(true);
        case "false", "0" -> new Bool(false);
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
              + kind.typeName()
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
      throw new IllegalArgumentException(decimal + " does not fit into " + kind.typeName());
    }
    return number;
  }
}
