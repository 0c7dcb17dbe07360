package org.sitaf.core.explain;

import java.math.BigInteger;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.Value;

/**
 * The values of a numeric type in their order, as whole numbers: neighbouring values have
 * neighbouring numbers. The middle of two floating-point numbers is that of their bits, so that few
 * steps separate any two.
 */
final class NumberLine {
  private final ScalarType type;

  NumberLine(InputElement element) {
    this.type = ((DataType.Scalar) element.type()).type();
  }

  long position(Value value) {
    if (type.isInteger()) {
      return ((Value.Whole) value).number().longValue();
    }
    double number = ((Value.Real) value).number();
    if (type == ScalarType.FLOAT) {
      int bits = Float.floatToIntBits((float) number);
      return bits >= 0 ? bits : Integer.MIN_VALUE - (long) bits;
    }
    long bits = Double.doubleToLongBits(number);
    return bits >= 0 ? bits : Long.MIN_VALUE - bits;
  }

  Value value(long position) {
    if (type.isInteger()) {
      return new Value.Whole(BigInteger.valueOf(position));
    }
    if (type == ScalarType.FLOAT) {
      float number =
          Float.intBitsToFloat((int) (position >= 0 ? position : Integer.MIN_VALUE - position));
      return new Value.Real(Double.parseDouble(Float.toString(number)));
    }
    return new Value.Real(
        Double.longBitsToDouble(position >= 0 ? position : Long.MIN_VALUE - position));
  }

  /** The position between two others. */
  static long middle(long a, long b) {
    return BigInteger.valueOf(a).add(BigInteger.valueOf(b)).shiftRight(1).longValue();
  }
}
