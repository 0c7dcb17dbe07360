package org.sitaf.core.value;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;

/**
 * Random numbers that are the same on every machine and in every version: SplitMix64 (Steele, Lea,
 * Flood: Fast Splittable Pseudorandom Number Generators, 2014), seeded by the suite's seed and the
 * element's name, so that one element's values do not change when another element is added.
 */
final class SeededRandom {
  private static final long FNV_OFFSET = 0xcbf29ce484222325L;
  private static final long FNV_PRIME = 0x100000001b3L;

  private long state;

  SeededRandom(long seed, String name) {
    long hash = FNV_OFFSET;
    for (byte b : name.getBytes(StandardCharsets.UTF_8)) {
      hash = (hash ^ (b & 0xff)) * FNV_PRIME;
    }
    state = seed * 0x9e3779b97f4a7c15L + hash;
  }

  long nextLong() {
    state += 0x9e3779b97f4a7c15L;
    long z = state;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }

  /** From 0, inclusive, to bound, exclusive. */
  int nextInt(int bound) {
    return (int) Long.remainderUnsigned(nextLong() >>> 1, bound);
  }

  /** From 0, inclusive, to 1, exclusive. */
  double nextDouble() {
    return (nextLong() >>> 11) * 0x1.0p-53;
  }

  /** From min to max, both inclusive. */
  BigInteger nextWhole(BigInteger min, BigInteger max) {
    BigInteger span = max.subtract(min).add(BigInteger.ONE);
    BigInteger random = BigInteger.ZERO;
    // 64 bits more than the span has, so that the remainder is even enough.
    for (int bits = 0; bits < span.bitLength() + 64; bits += 63) {
      random = random.shiftLeft(63).or(BigInteger.valueOf(nextLong() >>> 1));
    }
    return min.add(random.mod(span));
  }

  /** From min to max, both inclusive. */
  double nextReal(BigDecimal min, BigDecimal max) {
    double number =
        min.add(
                max.subtract(min).multiply(new BigDecimal(nextDouble()), MathContext.DECIMAL128),
                MathContext.DECIMAL128)
            .doubleValue();
    return Math.min(Math.max(number, min.doubleValue()), max.doubleValue());
  }

  /** Standard normal, by the polar method (Marsaglia). */
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
