package org.sitaf.runtime.component;

import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.CannotRunException;

/**
 * Reads the last value of an output data port: from the method with the port's name, its getter, or
 * the public field with its name.
 */
public final class DataPort {
  private DataPort() {}

  /**
   * Returns the value of a port.
   *
   * @throws CannotRunException when the component has no such method or field
   * @throws Exception what the component throws
   */
  public static @Nullable Object read(Object component, String port) throws Exception {
    Class<?> type = component.getClass();
    String getter = "get" + port.substring(0, 1).toUpperCase(Locale.ROOT) + port.substring(1);
    for (String name : new String[] {port, getter}) {
      try {
        return type.getMethod(name).invoke(component);
      } catch (NoSuchMethodException e) {
        // Try the next name.
      } catch (InvocationTargetException e) {
        throw e.getCause() instanceof Exception exception ? exception : e;
      }
    }
    try {
      Field field = type.getField(port);
      return field.get(component);
    } catch (NoSuchFieldException e) {
      throw new CannotRunException(
          type.getName()
              + " has neither a public method "
              + port
              + "() or "
              + getter
              + "() nor a public field "
              + port
              + " for the data port that the model observes",
          e);
    }
  }
}
