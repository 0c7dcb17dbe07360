package org.sitaf.runtime;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Starts a test application while it is still being compiled, with {@code EarlyStart ENTRY-POINT
 * ARGUMENTS} in place of {@code ENTRY-POINT ARGUMENTS}: reads the suite and opens the simulation,
 * which needs none of the application's classes, and waits. A line on standard input means that the
 * classes are compiled; it is the token for {@link org.sitaf.runtime.suite.ResultsFile}. The end of
 * the input without a line means that the process is no longer needed.
 */
public final class EarlyStart {
  /** The opened run, until the run with the same arguments takes it. */
  private static @Nullable TestRun opened;

  private static String[] openedWith = {};
  private static @Nullable String line;

  private EarlyStart() {}

  /**
   * Opens the run, waits for the line, and calls the entry point.
   *
   * @throws Throwable what the entry point throws
   */
  public static void main(String[] arguments) throws Throwable {
    String entryPoint = arguments[0];
    String[] applicationArguments = Arrays.copyOfRange(arguments, 1, arguments.length);
    try {
      opened = TestRun.open(applicationArguments);
      openedWith = applicationArguments;
    } catch (IOException | RuntimeException e) {
      // The run fails in the same way when it starts, and reports the failure.
    }
    line = StandardInput.line();
    if (line == null) {
      System.exit(TestRun.EXIT_CANNOT_RUN);
    }
    Method main = Class.forName(entryPoint).getMethod("main", String[].class);
    // The Java launcher requires a public method, but not a public class.
    main.setAccessible(true);
    try {
      main.invoke(null, (Object) applicationArguments);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  /** Takes the line that ended the wait; reads standard input if the process did not wait. */
  static synchronized @Nullable String takeLine() {
    String taken = line;
    line = null;
    return taken == null ? StandardInput.line() : taken;
  }

  /** Takes the run that was opened with these arguments; null when there is none. */
  static synchronized @Nullable TestRun take(String[] arguments) {
    TestRun taken = Arrays.equals(arguments, openedWith) ? opened : null;
    opened = null;
    return taken;
  }
}
