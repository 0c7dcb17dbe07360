package org.sitaf.runtime.suite;

import java.math.BigInteger;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * One test case: values by the names of the suite's parameters, and what is expected of the
 * outputs.
 *
 * <p>The accessors throw {@link CaseDataException} when the suite has no such parameter, or when
 * the type cannot hold its value.
 */
public final class TestCase {
  private final int no;
  private final boolean valid;
  private final Map<String, String> values;
  private final Map<String, String> expected;

  /**
   * A case.
   *
   * @param values literals by parameter, in the suite's order
   * @param expected literals by output; the empty name stands for the only one
   */
  public TestCase(int no, boolean valid, Map<String, String> values, Map<String, String> expected) {
    this.no = no;
    this.valid = valid;
    this.values = new LinkedHashMap<>(values);
    this.expected = new LinkedHashMap<>(expected);
  }

  /** Its number in the suite. */
  public int no() {
    return no;
  }

  /** Whether it holds no invalid value. */
  public boolean valid() {
    return valid;
  }

  /** What is expected of an output; empty when nothing is. */
  public Optional<String> expected(String output) {
    String named = expected.get(output);
    return Optional.ofNullable(named != null ? named : expected.get(""));
  }

  public byte byteValue(String parameter) {
    return (byte) whole(parameter, Byte.MIN_VALUE, Byte.MAX_VALUE);
  }

  public short shortValue(String parameter) {
    return (short) whole(parameter, Short.MIN_VALUE, Short.MAX_VALUE);
  }

  public int intValue(String parameter) {
    return (int) whole(parameter, Integer.MIN_VALUE, Integer.MAX_VALUE);
  }

  public long longValue(String parameter) {
    return whole(parameter, Long.MIN_VALUE, Long.MAX_VALUE);
  }

  public BigInteger bigIntegerValue(String parameter) {
    return read(parameter, TestCase::bigInteger);
  }

  public float floatValue(String parameter) {
    return (float) doubleValue(parameter);
  }

  public double doubleValue(String parameter) {
    return read(parameter, Literals::real);
  }

  public boolean booleanValue(String parameter) {
    return read(parameter, Literals::truth);
  }

  public char charValue(String parameter) {
    return read(parameter, Literals::character);
  }

  public String stringValue(String parameter) {
    return literal(parameter);
  }

  public byte[] byteArray(String parameter) {
    List<Long> elements = wholes(parameter, Byte.MIN_VALUE, Byte.MAX_VALUE);
    byte[] array = new byte[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i).byteValue();
    }
    return array;
  }

  public short[] shortArray(String parameter) {
    List<Long> elements = wholes(parameter, Short.MIN_VALUE, Short.MAX_VALUE);
    short[] array = new short[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i).shortValue();
    }
    return array;
  }

  public int[] intArray(String parameter) {
    return wholes(parameter, Integer.MIN_VALUE, Integer.MAX_VALUE).stream()
        .mapToInt(Long::intValue)
        .toArray();
  }

  public long[] longArray(String parameter) {
    return wholes(parameter, Long.MIN_VALUE, Long.MAX_VALUE).stream()
        .mapToLong(Long::longValue)
        .toArray();
  }

  public BigInteger[] bigIntegerArray(String parameter) {
    return elements(parameter, TestCase::bigInteger).toArray(BigInteger[]::new);
  }

  public float[] floatArray(String parameter) {
    double[] elements = doubleArray(parameter);
    float[] array = new float[elements.length];
    for (int i = 0; i < array.length; i++) {
      array[i] = (float) elements[i];
    }
    return array;
  }

  public double[] doubleArray(String parameter) {
    return elements(parameter, Literals::real).stream().mapToDouble(Double::doubleValue).toArray();
  }

  public boolean[] booleanArray(String parameter) {
    List<Boolean> elements = elements(parameter, Literals::truth);
    boolean[] array = new boolean[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i);
    }
    return array;
  }

  public char[] charArray(String parameter) {
    List<Character> elements = elements(parameter, Literals::character);
    char[] array = new char[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i);
    }
    return array;
  }

  public String[] stringArray(String parameter) {
    return elements(parameter, Function.identity()).toArray(String[]::new);
  }

  /** All literals in the suite's order. */
  Iterable<String> literals() {
    return values.values();
  }

  /** What is expected, by output. */
  Map<String, String> expectations() {
    return expected;
  }

  private String literal(String parameter) {
    String literal = values.get(parameter);
    if (literal == null) {
      throw new CaseDataException(
          "the suite has no parameter '"
              + parameter
              + "'; it has "
              + values.keySet()
              + ": generate the test application anew");
    }
    return literal;
  }

  private long whole(String parameter, long min, long max) {
    return read(parameter, literal -> Literals.whole(literal, min, max));
  }

  private List<Long> wholes(String parameter, long min, long max) {
    return elements(parameter, literal -> Literals.whole(literal, min, max));
  }

  private <T> List<T> elements(String parameter, Function<String, T> reading) {
    return read(parameter, literal -> Literals.elements(literal).stream().map(reading).toList());
  }

  private <T> T read(String parameter, Function<String, T> reading) {
    String literal = literal(parameter);
    try {
      return reading.apply(literal);
    } catch (CaseDataException e) {
      throw new CaseDataException(parameter + ": " + e.getMessage(), e);
    }
  }

  private static BigInteger bigInteger(String literal) {
    try {
      return Literals.decimal(literal).toBigIntegerExact();
    } catch (ArithmeticException e) {
      throw new CaseDataException("'" + literal + "' is not a whole number", e);
    }
  }
}
