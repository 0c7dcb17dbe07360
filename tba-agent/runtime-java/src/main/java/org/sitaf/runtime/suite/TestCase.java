package org.sitaf.runtime.suite;

import java.math.BigInteger;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * One test case: values by the names of the suite's parameters.
 *
 * <p>The accessors throw {@link CaseDataException} when the suite has no such parameter, or when
 * the type cannot hold its value.
 */
public class TestCase {
  private final int no;
  private final boolean valid;
  private final Map<String, String> values;
  private final List<TestStep> steps;

  /**
   * A case.
   *
   * @param values literals by parameter, in the suite's order
   */
  public TestCase(int no, boolean valid, Map<String, String> values) {
    this(no, valid, values, List.of());
  }

  /**
   * A case that is a sequence of calls and events.
   *
   * @param values initial literals by parameter, in the suite's order
   */
  public TestCase(int no, boolean valid, Map<String, String> values, List<TestStep> steps) {
    this.no = no;
    this.valid = valid;
    this.values = new LinkedHashMap<>(values);
    this.steps = List.copyOf(steps);
  }

  /** Its number in the suite. */
  public final int no() {
    return no;
  }

  /** The steps of a sequence; none if the case is a single call. */
  public final List<TestStep> steps() {
    return steps;
  }

  /** Whether it has no invalid value. */
  public final boolean valid() {
    return valid;
  }

  public final byte byteValue(String parameter) {
    return (byte) whole(parameter, Byte.MIN_VALUE, Byte.MAX_VALUE);
  }

  public final short shortValue(String parameter) {
    return (short) whole(parameter, Short.MIN_VALUE, Short.MAX_VALUE);
  }

  public final int intValue(String parameter) {
    return (int) whole(parameter, Integer.MIN_VALUE, Integer.MAX_VALUE);
  }

  public final long longValue(String parameter) {
    return whole(parameter, Long.MIN_VALUE, Long.MAX_VALUE);
  }

  public final BigInteger bigIntegerValue(String parameter) {
    return read(parameter, Literals::big);
  }

  public final float floatValue(String parameter) {
    return (float) doubleValue(parameter);
  }

  public final double doubleValue(String parameter) {
    return read(parameter, Literals::real);
  }

  public final boolean booleanValue(String parameter) {
    return read(parameter, Literals::parseBoolean);
  }

  public final char charValue(String parameter) {
    return read(parameter, Literals::parseCharacter);
  }

  public final String stringValue(String parameter) {
    return literal(parameter);
  }

  public final byte[] byteArray(String parameter) {
    List<Long> elements = wholes(parameter, Byte.MIN_VALUE, Byte.MAX_VALUE);
    byte[] array = new byte[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i).byteValue();
    }
    return array;
  }

  public final short[] shortArray(String parameter) {
    List<Long> elements = wholes(parameter, Short.MIN_VALUE, Short.MAX_VALUE);
    short[] array = new short[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i).shortValue();
    }
    return array;
  }

  public final int[] intArray(String parameter) {
    return wholes(parameter, Integer.MIN_VALUE, Integer.MAX_VALUE).stream()
        .mapToInt(Long::intValue)
        .toArray();
  }

  public final long[] longArray(String parameter) {
    return wholes(parameter, Long.MIN_VALUE, Long.MAX_VALUE).stream()
        .mapToLong(Long::longValue)
        .toArray();
  }

  public final BigInteger[] bigIntegerArray(String parameter) {
    return elements(parameter, Literals::big).toArray(BigInteger[]::new);
  }

  public final float[] floatArray(String parameter) {
    double[] elements = doubleArray(parameter);
    float[] array = new float[elements.length];
    for (int i = 0; i < array.length; i++) {
      array[i] = (float) elements[i];
    }
    return array;
  }

  public final double[] doubleArray(String parameter) {
    return elements(parameter, Literals::real).stream().mapToDouble(Double::doubleValue).toArray();
  }

  public final boolean[] booleanArray(String parameter) {
    List<Boolean> elements = elements(parameter, Literals::parseBoolean);
    boolean[] array = new boolean[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i);
    }
    return array;
  }

  public final char[] charArray(String parameter) {
    List<Character> elements = elements(parameter, Literals::parseCharacter);
    char[] array = new char[elements.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = elements.get(i);
    }
    return array;
  }

  public final String[] stringArray(String parameter) {
    return elements(parameter, Function.identity()).toArray(String[]::new);
  }

  /** A value of a generated type: an enumeration, a record, or an array. */
  public final <T> T value(String parameter, Class<T> type) {
    return type.cast(read(parameter, literal -> Conversion.convert(literal, type)));
  }

  /**
   * The answers of a stubbed method or of one of its out-parameters, from the parameters with this
   * name and with {@code #2} and so on appended to it.
   *
   * @param type the boxed type
   * @param unset the value when the suite has none, or only a delay
   */
  public final <T> Answers<T> answers(String name, Class<T> type, @Nullable T unset) {
    Map<Integer, Answer<T>> fromCall = new HashMap<>();
    for (String parameter : values.keySet()) {
      boolean first = parameter.equals(name);
      if (first || parameter.startsWith(name + "#")) {
        int call = first ? 1 : Integer.parseInt(parameter.substring(name.length() + 1));
        fromCall.put(
            call,
            read(
                parameter,
                literal ->
                    Answer.read(literal, unset, l -> type.cast(Conversion.convert(l, type)))));
      }
    }
    return new Answers<>(unset, fromCall);
  }

  private String literal(String parameter) {
    String literal = values.get(parameter);
    if (literal == null) {
      throw new CaseDataException(
          "the suite has no parameter '"
              + parameter
              + "'; it has "
              + values.keySet()
              + ": generate the test application again");
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
}
