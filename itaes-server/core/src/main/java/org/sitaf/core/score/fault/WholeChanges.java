package org.sitaf.core.score.fault;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.UnaryOperator;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Decimals;
import org.sitaf.core.verdict.Literals;

/** Faults of integers: off by one, signs, scales, widths and byte orders, lost values. */
final class WholeChanges {
  private static final int MAX_LENGTH = 40;
  private static final BigInteger BYTE = BigInteger.valueOf(0xFF);

  private final BigInteger minimum;
  private final BigInteger maximum;
  private final List<ValueChange> changes = new ArrayList<>();

  private WholeChanges(ScalarType type) {
    minimum = Objects.requireNonNull(type.minimum());
    maximum = Objects.requireNonNull(type.maximum());
  }

  /** All faults of an integer type. */
  static List<ValueChange> all(ScalarType type) {
    WholeChanges all = new WholeChanges(type);
    all.few();
    all.further();
    return all.changes;
  }

  /** A few faults of different kinds, for values that consist of many numbers. */
  static List<ValueChange> few(ScalarType type) {
    WholeChanges some = new WholeChanges(type);
    some.few();
    return some.changes;
  }

  private void few() {
    add("one too large", x -> x.add(BigInteger.ONE));
    add("one too small", x -> x.subtract(BigInteger.ONE));
    add("sign inverted", BigInteger::negate);
    add("always 0", x -> BigInteger.ZERO);
  }

  private void further() {
    add("sign lost", BigInteger::abs);
    for (int factor : new int[] {2, 1000}) {
      add(factor + " times the value", x -> x.multiply(BigInteger.valueOf(factor)));
      add("divided by " + factor, x -> x.divide(BigInteger.valueOf(factor)));
    }
    add("always 1", x -> BigInteger.ONE);
    add("the largest number instead of the value", x -> maximum);
    add("the lowest byte read with a sign", x -> BigInteger.valueOf(x.byteValue()));
    add(
        "bytes of the lowest 16 bits swapped",
        x -> x.and(BYTE).shiftLeft(8).or(x.shiftRight(8).and(BYTE)));
  }

  private void add(String text, UnaryOperator<BigInteger> change) {
    changes.add(new ValueChange(text, literal -> changed(literal, change)));
  }

  private String changed(String literal, UnaryOperator<BigInteger> change) {
    if (literal.length() > MAX_LENGTH || !Literals.isNumber(literal)) {
      return literal;
    }
    BigInteger number;
    try {
      number = Decimals.parse(literal).toBigIntegerExact();
    } catch (ArithmeticException | IllegalArgumentException e) {
      return literal;
    }
    BigInteger result = change.apply(number);
    boolean fits = result.compareTo(minimum) >= 0 && result.compareTo(maximum) <= 0;
    return fits && !result.equals(number) ? result.toString() : literal;
  }
}
