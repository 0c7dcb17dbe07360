package org.sitaf.core.expression.function;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Functions of vectors: lists of numbers, or structs with the members x, y and z. */
final class Vectors {
  private static final List<String> AXES = List.of("x", "y", "z");

  private Vectors() {}

  /** Whether a value has the form of a vector. */
  static boolean isVector(Object value) {
    return value instanceof List<?> || isStruct(value);
  }

  private static boolean isStruct(Object value) {
    return value instanceof Map<?, ?> map
        && map.keySet().containsAll(AXES)
        && !map.containsKey("w");
  }

  private static List<?> elements(String function, Object value) {
    if (value instanceof List<?> list) {
      return list;
    }
    if (isStruct(value)) {
      Map<?, ?> map = (Map<?, ?>) value;
      return AXES.stream().map(map::get).toList();
    }
    throw new IllegalArgumentException(
        function
            + " needs a list of numbers or a struct with x, y and z, not "
            + Numbers.shown(value));
  }

  static double[] numbers(String function, Object value) {
    List<?> elements = elements(function, value);
    double[] numbers = new double[elements.size()];
    int i = 0;
    for (Object each : elements) {
      if (!Numbers.isNumber(each)) {
        throw new IllegalArgumentException(function + " needs numbers, not " + Numbers.shown(each));
      }
      numbers[i++] = Numbers.real(each);
    }
    return numbers;
  }

  /** A vector in the form of another one: a struct or a list. */
  static Object like(Object form, double[] vector) {
    if (form instanceof Map<?, ?> && vector.length == AXES.size()) {
      Map<String, Object> struct = new LinkedHashMap<>();
      for (int i = 0; i < vector.length; i++) {
        struct.put(AXES.get(i), vector[i]);
      }
      return struct;
    }
    List<Object> list = new ArrayList<>(vector.length);
    for (double each : vector) {
      list.add(each);
    }
    return list;
  }

  /** The sum; whole if all elements are. */
  static Object sum(Object vector) {
    Object sum = 0L;
    boolean first = true;
    for (Object each : elements("sum", vector)) {
      if (!Numbers.isNumber(each)) {
        throw new IllegalArgumentException("sum needs numbers, not " + Numbers.shown(each));
      }
      sum = first ? each : Arithmetic.add(sum, each);
      first = false;
    }
    return sum;
  }

  /** The arithmetic mean; NaN if there are no elements. */
  static double mean(Object vector) {
    double sum = 0;
    double[] numbers = numbers("mean", vector);
    for (double each : numbers) {
      sum += each;
    }
    return sum / numbers.length;
  }

  /** The Euclidean norm, without overflow of the squares. */
  static double norm(Object vector) {
    return norm(numbers("norm", vector));
  }

  static double norm(double[] numbers) {
    double largest = 0;
    for (double each : numbers) {
      if (Double.isInfinite(each)) {
        return Double.POSITIVE_INFINITY;
      }
      // Math.max gives NaN if one of them is.
      largest = Math.max(largest, Math.abs(each));
    }
    if (largest == 0 || Double.isNaN(largest)) {
      return largest;
    }
    // A power of two, so that the division is exact.
    double scale = Math.scalb(1.0, Math.min(Math.getExponent(largest), Double.MAX_EXPONENT - 1));
    scale = scale < Double.MIN_NORMAL ? Double.MIN_NORMAL : scale;
    double squares = 0;
    for (double each : numbers) {
      double scaled = each / scale;
      squares += scaled * scaled;
    }
    return Math.sqrt(squares) * scale;
  }

  /** The scalar product; whole if all elements are. */
  static Object dot(Object a, Object b) {
    List<?> first = elements("dot", a);
    List<?> second = elements("dot", b);
    requireEqual("dot", first.size(), second.size());
    numbers("dot", a);
    numbers("dot", b);
    Object sum = 0L;
    for (int i = 0; i < first.size(); i++) {
      Object product = Arithmetic.multiply(first.get(i), second.get(i));
      sum = i == 0 ? product : Arithmetic.add(sum, product);
    }
    return sum;
  }

  /** The vector product, in the form of the first vector. */
  static Object cross(Object a, Object b) {
    double[] u = numbers("cross", a);
    double[] v = numbers("cross", b);
    if (u.length != 3 || v.length != 3) {
      throw new IllegalArgumentException(
          "cross needs two vectors of 3 numbers, not of " + u.length + " and " + v.length);
    }
    return like(a, cross(u, v));
  }

  static double[] cross(double[] u, double[] v) {
    return new double[] {
      u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
    };
  }

  /** Whether no element is less than the one before it. */
  static boolean isSorted(Object vector) {
    double[] numbers = numbers("is_sorted", vector);
    for (int i = 1; i < numbers.length; i++) {
      if (!(numbers[i - 1] <= numbers[i])) {
        return false;
      }
    }
    return numbers.length != 1 || !Double.isNaN(numbers[0]);
  }

  static void requireEqual(String function, int a, int b) {
    if (a != b) {
      throw new IllegalArgumentException(
          function + " needs two vectors of the same length, not of " + a + " and " + b);
    }
  }
}
