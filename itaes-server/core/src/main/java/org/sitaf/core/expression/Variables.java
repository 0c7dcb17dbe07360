package org.sitaf.core.expression;

import com.google.common.primitives.UnsignedLong;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.model.Value;

/**
 * The variables of a test case for an expression: each input by name. Paths such as {@code pose.x}
 * and {@code path[0]} become members and elements. Each name of a fault is one variable, and its
 * {@code .at}, {@code .for} and {@code .end} always have values.
 */
public final class Variables {
  /** True if the case has no invalid value. */
  public static final String VALID = "valid";

  /** Prefix of a variable that is true if the value of an input is valid. */
  public static final String VALID_PREFIX = "valid_";

  /** The name of the exception that the call threw; empty if it threw none. */
  public static final String ERROR = "error";

  /** The calls of required interfaces: a map of {@code Interface.Method} to a list. */
  public static final String CALLS = "calls";

  /** The messages of a ROS 2 node: a map of the output to a list. */
  public static final String MESSAGES = "messages";

  private static final Pattern STEP =
      Pattern.compile("([A-Za-z_]\\w*)|\\.([A-Za-z_]\\w*)|\\[(\\d{1,6})]");
  private static final BigInteger LONG_MIN = BigInteger.valueOf(Long.MIN_VALUE);
  private static final BigInteger LONG_MAX = BigInteger.valueOf(Long.MAX_VALUE);

  private final Map<String, Object> values = new HashMap<>();

  /**
   * The variable names for inputs. A name that is not a path, such as one with {@code #2}, has no
   * variable.
   */
  public static Set<String> roots(Collection<String> names) {
    Set<String> roots = new TreeSet<>();
    for (String name : names) {
      List<Object> path = path(name);
      if (!path.isEmpty()) {
        roots.add((String) path.get(0));
      }
      FaultName.find(name).ifPresent(fault -> roots.add(fault.fault() + FaultName.END));
    }
    return roots;
  }

  /** Adds the value of an input. */
  public Variables put(String name, Value value, DataType type) {
    return put(name, value.literal(), type);
  }

  /** Adds the value of an input by its literal. */
  public Variables put(String name, String literal, DataType type) {
    List<Object> path = path(name);
    if (!path.isEmpty()) {
      put(values, path, plain(literal, type));
    }
    FaultName.find(name).ifPresent(this::putTimes);
    return this;
  }

  /** The times of a fault: those that no input sets have their defaults. */
  private void putTimes(FaultName fault) {
    String name = fault.fault();
    Object at = values.computeIfAbsent(name + FaultName.Part.AT.suffix(), n -> 0.0);
    Object length =
        values.computeIfAbsent(name + FaultName.Part.FOR.suffix(), n -> Double.POSITIVE_INFINITY);
    if (at instanceof Number begin && length instanceof Number duration) {
      values.put(name + FaultName.END, begin.doubleValue() + duration.doubleValue());
    }
  }

  /** Adds whether the value of an input is valid: {@code valid_pose.x} of {@code pose.x}. */
  public Variables putValidity(String name, boolean valid) {
    List<Object> path = path(VALID_PREFIX + name);
    if (!path.isEmpty()) {
      put(values, path, valid);
    }
    return this;
  }

  /** Adds a variable that is not an input, such as {@code valid}. */
  public Variables put(String name, Object plainValue) {
    values.put(name, plainValue);
    return this;
  }

  /** The variables for an evaluation. */
  public Map<String, Object> map() {
    return values;
  }

  /** Converts a value for CEL: Long, UnsignedLong, Double, Boolean or String. */
  public static Object plain(Value value) {
    if (value instanceof Value.Whole whole) {
      BigInteger number = whole.number();
      return number.compareTo(LONG_MIN) >= 0 && number.compareTo(LONG_MAX) <= 0
          ? (Object) number.longValue()
          : UnsignedLong.valueOf(number);
    }
    if (value instanceof Value.Real real) {
      return real.number();
    }
    return value instanceof Value.Bool bool ? (Object) bool.value() : value.literal();
  }

  /**
   * Converts a literal for CEL: as {@link #plain(Value)}, and List or Map for a sequence or struct.
   * An error or a delay remains a String.
   *
   * @throws IllegalArgumentException if it is not a value of the type
   */
  public static Object plain(String literal, DataType type) {
    return Value.isErrorOrDelay(literal) ? literal : StructuredLiteral.plain(literal, type);
  }

  static List<Object> path(String name) {
    // The names of faults begin with one another: fault.ir1.dropout and fault.ir1.dropout.at.
    if (FaultName.find(name).isPresent()
        || (name.startsWith(VALID_PREFIX)
            && FaultName.find(name.substring(VALID_PREFIX.length())).isPresent())) {
      return List.of(name);
    }
    List<Object> path = new ArrayList<>();
    Matcher step = STEP.matcher(name);
    int at = 0;
    while (at < name.length() && step.find(at) && step.start() == at) {
      if ((step.group(1) != null) != path.isEmpty()) {
        return List.of();
      }
      path.add(
          step.group(1) != null
              ? step.group(1)
              : step.group(2) != null ? step.group(2) : (Object) Integer.valueOf(step.group(3)));
      at = step.end();
    }
    return at == name.length() ? path : List.of();
  }

  @SuppressWarnings("unchecked")
  private static void put(Map<String, Object> root, List<Object> path, Object value) {
    Object container = root;
    for (int i = 0; i < path.size(); i++) {
      boolean last = i == path.size() - 1;
      Object next =
          last ? value : path.get(i + 1) instanceof Integer ? new ArrayList<>() : new HashMap<>();
      if (path.get(i) instanceof Integer index) {
        List<Object> list = (List<Object>) container;
        while (list.size() <= index) {
          list.add(0.0);
        }
        if (last || !(list.get(index) instanceof Map || list.get(index) instanceof List)) {
          list.set(index, next);
        }
        container = list.get(index);
      } else {
        Map<String, Object> map = (Map<String, Object>) container;
        String key = (String) path.get(i);
        Object held = map.get(key);
        if (!last && held != null && !(held instanceof Map || held instanceof List)) {
          // The return value of a stub takes precedence over an out-parameter of the same method.
          return;
        }
        if (last || held == null) {
          map.put(key, next);
        }
        container = map.get(key);
      }
    }
  }
}
