package org.sitaf.runtime;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** Creates a component and sets its properties by reflection on its class. */
public final class ComponentUnderTest {
  /** Setters by name; cached because components may be created for each case. */
  private static final ClassValue<Map<String, List<Method>>> SETTERS =
      new ClassValue<>() {
        @Override
        protected Map<String, List<Method>> computeValue(Class<?> type) {
          return Arrays.stream(type.getMethods())
              .filter(m -> m.getName().startsWith("set"))
              .filter(m -> !Modifier.isStatic(m.getModifiers()) && !m.isBridge())
              .sorted(Comparator.comparing(Method::toString))
              .collect(Collectors.groupingBy(Method::getName));
        }
      };

  /** Public constructors, those with the most parameters first. */
  private static final ClassValue<List<Constructor<?>>> CONSTRUCTORS =
      new ClassValue<>() {
        @Override
        protected List<Constructor<?>> computeValue(Class<?> type) {
          return Arrays.stream(type.getConstructors())
              .sorted(
                  Comparator.<Constructor<?>>comparingInt(c -> c.getParameterCount()).reversed())
              .toList();
        }
      };

  private ComponentUnderTest() {}

  /**
   * Creates a component with the public constructor that has the most parameters and whose
   * parameters are all types of available objects.
   *
   * @param available objects for the constructor: hardware, stubs of required interfaces
   * @throws CannotRunException when no constructor fits
   * @throws Exception what the constructor throws
   */
  public static <T> T create(Class<T> type, Object... available) throws Exception {
    if (type.isInterface() || Modifier.isAbstract(type.getModifiers())) {
      throw new CannotRunException(type.getName() + " is abstract: name a class that can be made");
    }
    for (Constructor<?> constructor : CONSTRUCTORS.get(type)) {
      Optional<Object[]> arguments = arguments(constructor, available);
      if (arguments.isPresent()) {
        try {
          return type.cast(constructor.newInstance(arguments.get()));
        } catch (InvocationTargetException e) {
          throw thrownBy(e);
        }
      }
    }
    throw noConstructor(type, available);
  }

  /**
   * Sets a property with {@code setProperty(String, String)} if the class has this method,
   * otherwise with the setter of the property, whose parameter type the value is converted to.
   *
   * @throws CannotRunException when the class has neither, or the value does not fit
   * @throws Exception what the component throws
   */
  public static void setProperty(Object component, String name, String value) throws Exception {
    Class<?> type = component.getClass();
    Optional<Method> general =
        setters(type, "setProperty")
            .filter(
                m ->
                    Arrays.equals(
                        m.getParameterTypes(), new Class<?>[] {String.class, String.class}))
            .findFirst();
    if (general.isPresent()) {
      invoke(general.get(), component, name, value);
      return;
    }
    String setter =
        name.isEmpty()
            ? "set"
            : "set" + name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    List<Method> candidates =
        setters(type, setter).filter(m -> m.getParameterCount() == 1).toList();
    for (Method candidate : candidates) {
      Object converted = converted(value, candidate.getParameterTypes()[0]);
      if (converted != null) {
        invoke(candidate, component, converted);
        return;
      }
    }
    throw new CannotRunException(
        type.getName()
            + (candidates.isEmpty()
                ? " has neither setProperty(String, String) nor " + setter + "(...)"
                : "."
                    + setter
                    + " takes "
                    + typesOf(candidates)
                    + ", which cannot be made of '"
                    + value
                    + "'")
            + " for the property '"
            + name
            + "' of activity.yaml");
  }

  /** The arguments for a constructor; empty when an object that it needs is not available. */
  private static Optional<Object[]> arguments(Constructor<?> constructor, Object[] available) {
    List<Object> arguments = new ArrayList<>();
    for (Class<?> wanted : constructor.getParameterTypes()) {
      Optional<Object> fitting = Arrays.stream(available).filter(wanted::isInstance).findFirst();
      if (fitting.isEmpty() || wanted == Object.class) {
        return Optional.empty();
      }
      arguments.add(fitting.get());
    }
    return Optional.of(arguments.toArray());
  }

  private static CannotRunException noConstructor(Class<?> type, Object[] available) {
    String offered =
        available.length == 0
            ? "nothing (the activity has neither a world nor required interfaces)"
            : Arrays.stream(available)
                .map(ComponentUnderTest::roles)
                .collect(Collectors.joining(", "));
    String has =
        Arrays.stream(type.getConstructors())
            .map(c -> "(" + typesOf(c.getParameterTypes()) + ")")
            .collect(Collectors.joining(", "));
    return new CannotRunException(
        type.getName()
            + " has no public constructor that takes any of: "
            + offered
            + "; it has "
            + (has.isEmpty() ? "no public constructor" : has)
            + (Modifier.isPublic(type.getModifiers()) ? "" : ", and the class is not public"));
  }

  /** The interfaces that an object implements. */
  private static String roles(Object object) {
    Class<?>[] interfaces = object.getClass().getInterfaces();
    return interfaces.length == 0 ? object.getClass().getName() : typesOf(interfaces);
  }

  private static Stream<Method> setters(Class<?> type, String name) {
    return SETTERS.get(type).getOrDefault(name, List.of()).stream();
  }

  private static void invoke(Method method, Object component, Object... arguments)
      throws Exception {
    try {
      method.invoke(component, arguments);
    } catch (InvocationTargetException e) {
      throw thrownBy(e);
    } catch (IllegalAccessException e) {
      throw new CannotRunException(
          component.getClass().getName()
              + " must be public, so that '"
              + method.getName()
              + "' can be called",
          e);
    }
  }

  private static Exception thrownBy(InvocationTargetException e) {
    Throwable cause = e.getCause();
    if (cause instanceof Error error) {
      throw error;
    }
    return cause instanceof Exception exception ? exception : e;
  }

  /** Converts a value to a type; null when the conversion is not possible. */
  private static @Nullable Object converted(String value, Class<?> type) {
    String text = value.strip();
    try {
      if (type == String.class) {
        return value;
      } else if (type == int.class || type == Integer.class) {
        return Integer.valueOf(text);
      } else if (type == long.class || type == Long.class) {
        return Long.valueOf(text);
      } else if (type == short.class || type == Short.class) {
        return Short.valueOf(text);
      } else if (type == byte.class || type == Byte.class) {
        return Byte.valueOf(text);
      } else if (type == double.class || type == Double.class) {
        return Double.valueOf(text);
      } else if (type == float.class || type == Float.class) {
        return Float.valueOf(text);
      } else if (type == boolean.class || type == Boolean.class) {
        return text.equals("true") || text.equals("false") ? Boolean.valueOf(text) : null;
      } else if (type == char.class || type == Character.class) {
        return value.length() == 1 ? value.charAt(0) : null;
      }
      return null;
    } catch (NumberFormatException e) {
      return null;
    }
  }

  private static String typesOf(List<Method> setters) {
    return setters.stream()
        .map(m -> typesOf(m.getParameterTypes()))
        .collect(Collectors.joining(" or "));
  }

  private static String typesOf(Class<?>[] types) {
    return Arrays.stream(types).map(Class::getName).collect(Collectors.joining(", "));
  }
}
