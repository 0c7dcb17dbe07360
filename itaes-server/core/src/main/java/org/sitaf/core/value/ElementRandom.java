package org.sitaf.core.value;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import org.sitaf.core.combine.SeededRandom;

/**
 * Random values of one test element. Seeded with the suite's seed and the element's name, so the
 * values of an element do not change when another element is added.
 */
final class ElementRandom {
  private static final long FNV_OFFSET = 0xcbf29ce484222325L;
  private static final long FNV_PRIME = 0x100000001b3L;

  private final SeededRandom random;

  ElementRandom(long seed, String name) {
    long hash = FNV_OFFSET;
    for (byte b : name.getBytes(StandardCharsets.UTF_8)) {
      hash = (hash ^ (b & 0xff)) * FNV_PRIME;
    }
    random = new SeededRandom(seed * 0x9e3779b97f4a7c15L + hash);
  }

  /** A number from 0 (inclusive) to {@code bound} (exclusive). */
  int nextInt(int bound) {
    return (int) Long.remainderUnsigned(random.nextLong() >>> 1, bound);
  }

  /** A number from 0 (inclusive) to 1 (exclusive). */
  double nextDouble() {
    return random.nextDouble();
  }

  /** An integer from min to max, both inclusive. */
  BigInteger nextInteger(BigInteger min, BigInteger max) {
    BigInteger span = max.subtract(min).add(BigInteger.ONE);
    BigInteger number = BigInteger.ZERO;
    // 64 bits more than the span, so the bias of the remainder is negligible.
    for (int bits = 0; bits < span.bitLength() + 64; bits += 63) {
      number = number.shiftLeft(63).or(BigInteger.valueOf(random.nextLong() >>> 1));
    }
    return min.add(number.mod(span));
  }

  /** A number from min to max, both inclusive. */
  double nextReal(BigDecimal min, BigDecimal max) {
    double number =
        min.add(
                max.subtract(min).multiply(new BigDecimal(nextDouble()), MathContext.DECIMAL128),
                MathContext.DECIMAL128)
            .doubleValue();
    return Math.min(Math.max(number, min.doubleValue()), max.doubleValue());
  }

  /** A number of the standard normal distribution, by the polar method (Marsaglia). */
  double nextNormal() {
    while (true) {
      double x = 2 * nextDouble() - 1;
      double y = 2 * nextDouble() - 1;
      double s = x * x + y * y;
      if (s > 0 && s < 1) {
        return x * StrictMath.sqrt(-2 * StrictMath.log(s) / s);
      }
    }
  }
}
