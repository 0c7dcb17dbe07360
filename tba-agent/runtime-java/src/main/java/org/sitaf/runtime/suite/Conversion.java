package org.sitaf.runtime.suite;

import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.math.BigInteger;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Converts literals to values of generated types. */
final class Conversion {
  private Conversion() {}

  /**
   * Converts a literal to a primitive or its wrapper, a String, a BigInteger, an enumeration, a
   * record that has a constructor without parameters, or an array of these.
   *
   * @throws CaseDataException when the type cannot hold the literal
   */
  static Object convert(String literal, Class<?> type) {
    if (type.isArray()) {
      List<String> elements = Literals.elements(literal);
      Object array = Array.newInstance(type.getComponentType(), elements.size());
      for (int i = 0; i < elements.size(); i++) {
        Array.set(array, i, convert(elements.get(i), type.getComponentType()));
      }
      return array;
    }
    if (type.isRecord()) {
      return struct(literal, type);
    }
    if (type.isEnum()) {
      for (Object constant : type.getEnumConstants()) {
        if (DocumentNames.of((Enum<?>) constant).equals(literal.strip())) {
          return constant;
        }
      }
      throw new CaseDataException(
          "'"
              + literal
              + "' is not one of "
              + Arrays.stream(type.getEnumConstants())
                  .map(constant -> DocumentNames.of((Enum<?>) constant))
                  .collect(Collectors.joining(", ")));
    }
    return scalar(literal, type);
  }

  private static Object scalar(String literal, Class<?> type) {
    if (type == double.class || type == Double.class) {
      return Literals.real(literal);
    } else if (type == float.class || type == Float.class) {
      return (float) Literals.real(literal);
    } else if (type == int.class || type == Integer.class) {
      return (int) Literals.whole(literal, Integer.MIN_VALUE, Integer.MAX_VALUE);
    } else if (type == long.class || type == Long.class) {
      return Literals.whole(literal, Long.MIN_VALUE, Long.MAX_VALUE);
    } else if (type == short.class || type == Short.class) {
      return (short) Literals.whole(literal, Short.MIN_VALUE, Short.MAX_VALUE);
    } else if (type == byte.class || type == Byte.class) {
      return (byte) Literals.whole(literal, Byte.MIN_VALUE, Byte.MAX_VALUE);
    } else if (type == BigInteger.class) {
      return Literals.big(literal);
    } else if (type == boolean.class || type == Boolean.class) {
      return Literals.parseBoolean(literal);
    } else if (type == char.class || type == Character.class) {
      return Literals.parseCharacter(literal);
    } else if (type == String.class) {
      return literal;
    }
    throw new CaseDataException("a value of " + type.getName() + " cannot be read");
  }

  /** Members that the literal omits get the values of the record's default constructor. */
  private static Object struct(String literal, Class<?> type) {
    RecordComponent[] components = type.getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    Object[] values = new Object[components.length];
    Map<String, String> rest = Literals.members(literal);
    try {
      Object zero = type.getConstructor().newInstance();
      for (int i = 0; i < components.length; i++) {
        types[i] = components[i].getType();
        String member = rest.remove(DocumentNames.of(components[i]));
        values[i] =
            member == null ? components[i].getAccessor().invoke(zero) : convert(member, types[i]);
      }
      if (!rest.isEmpty()) {
        throw new CaseDataException(
            "'"
                + literal
                + "' has an unknown member "
                + rest.keySet().iterator().next()
                + "; the struct has "
                + Arrays.stream(components)
                    .map(DocumentNames::of)
                    .collect(Collectors.joining(", ")));
      }
      Constructor<?> constructor = type.getConstructor(types);
      return constructor.newInstance(values);
    } catch (ReflectiveOperationException e) {
      throw new CaseDataException("a value of " + type.getName() + " cannot be made", e);
    }
  }
}
