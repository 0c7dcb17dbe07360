package org.sitaf.core.value;

import java.math.BigDecimal;
import java.math.BigInteger;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.RelatedOffset;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.spatial.SpatialType;

/** Adds an offset to the value of another input. */
public final class RelatedValue {
  private static final BigDecimal PERCENT = BigDecimal.valueOf(100);

  private RelatedValue() {}

  /**
   * The value next to another one.
   *
   * @param followed the other input, of the same type
   * @param value its value in the case
   * @throws IllegalArgumentException if the type cannot hold the result
   */
  public static Value of(InputElement followed, Value value, RelatedOffset offset) {
    DataType type = followed.type();
    if (value instanceof Value.Whole whole) {
      return Value.parse(whole(whole.number(), offset).toPlainString(), type);
    }
    if (value instanceof Value.Real real) {
      return new Value.Real(
          type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.FLOAT
              ? single((float) real.number(), offset)
              : real(real.number(), offset));
    }
    if (!(type instanceof DataType.Scalar) && offset.unit() == RelatedOffset.Unit.NUMBER) {
      return new Value.Text(
          SpatialType.of(type, followed.specs(), value.literal())
              .turned(value.literal(), offset.amount().doubleValue()));
    }
    throw new IllegalArgumentException(
        offset.text() + " cannot be added to '" + value.literal() + "'");
  }

  private static BigDecimal whole(BigInteger number, RelatedOffset offset) {
    BigDecimal decimal = new BigDecimal(number);
    return switch (offset.unit()) {
      case NUMBER, ULP -> decimal.add(offset.amount());
      case PERCENT -> decimal.add(decimal.abs().multiply(offset.amount()).divide(PERCENT));
    };
  }

  private static double real(double number, RelatedOffset offset) {
    double amount = offset.amount().doubleValue();
    return finite(
        number,
        switch (offset.unit()) {
          case NUMBER -> number + amount;
          case ULP -> steps(number, offset.amount().longValueExact());
          case PERCENT -> number + amount / 100 * Math.abs(number);
        });
  }

  private static double single(float number, RelatedOffset offset) {
    double amount = offset.amount().doubleValue();
    float result =
        switch (offset.unit()) {
          case NUMBER -> (float) (number + amount);
          case ULP -> steps(number, offset.amount().longValueExact());
          case PERCENT -> (float) (number + amount / 100 * Math.abs(number));
        };
    finite(number, result);
    // The shortest decimal of the float, as for all other values of this type.
    return Double.parseDouble(Float.toString(result));
  }

  private static double finite(double number, double result) {
    if (Double.isInfinite(result) && !Double.isInfinite(number)) {
      throw new IllegalArgumentException("the result is beyond the largest number of the type");
    }
    return result;
  }

  private static double steps(double number, long steps) {
    if (Double.isNaN(number)) {
      return number;
    }
    long infinity = Double.doubleToLongBits(Double.POSITIVE_INFINITY);
    long bits = Double.doubleToLongBits(number);
    long at = bits < 0 ? Long.MIN_VALUE - bits : bits;
    long next = bounded(Math.addExact(at, steps), infinity);
    return Double.longBitsToDouble(next < 0 ? Long.MIN_VALUE - next : next);
  }

  private static float steps(float number, long steps) {
    if (Float.isNaN(number)) {
      return number;
    }
    int infinity = Float.floatToIntBits(Float.POSITIVE_INFINITY);
    int bits = Float.floatToIntBits(number);
    long at = bits < 0 ? Integer.MIN_VALUE - bits : bits;
    int next = (int) bounded(Math.addExact(at, steps), infinity);
    return Float.intBitsToFloat(next < 0 ? Integer.MIN_VALUE - next : next);
  }

  private static long bounded(long at, long infinity) {
    return Math.max(-infinity, Math.min(infinity, at));
  }
}
