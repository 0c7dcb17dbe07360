package org.sitaf.runtime;

import java.io.FileOutputStream;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Arrays;

/**
 * Starts a test application when a debugger has set its breakpoints: the arguments are a named
 * pipe, the main class of the test application, and its arguments. The last command that the
 * debugger gets is to read the pipe.
 */
public final class DebugStart {
  private DebugStart() {}

  /**
   * Waits for a reader of the pipe and calls the main class.
   *
   * @throws Throwable what the main class throws
   */
  public static void main(String[] arguments) throws Throwable {
    // Opening a named pipe waits until it is also opened at its other end.
    new FileOutputStream(arguments[0]).close();
    Method main = Class.forName(arguments[1]).getMethod("main", String[].class);
    // The Java launcher requires a public method, but not a public class.
    main.setAccessible(true);
    try {
      main.invoke(null, (Object) Arrays.copyOfRange(arguments, 2, arguments.length));
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }
}
