package org.sitaf.runtime;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Describes an exception of a component in one message. */
final class ThrownByComponent {
  private static final int FRAMES = 4;
  private static final int CAUSES = 3;
  private static final List<String> NOT_THE_USERS =
      List.of(
          "java.",
          "javax.",
          "jdk.",
          "sun.",
          "com.sun.",
          "io.grpc.",
          "org.sitaf.runtime.",
          "sitaf.harness.");

  private ThrownByComponent() {}

  /** Class, message and the first frames in the user's code, of the exception and of its causes. */
  static String describe(Throwable thrown) {
    StringBuilder text = new StringBuilder();
    Throwable current = thrown;
    for (int depth = 0; current != null && depth <= CAUSES; depth++) {
      text.append(depth == 0 ? "" : "; caused by ").append(describeOne(current));
      current = current.getCause() == current ? null : current.getCause();
    }
    return text.toString();
  }

  private static String describeOne(Throwable thrown) {
    String frames =
        Arrays.stream(thrown.getStackTrace())
            .filter(f -> NOT_THE_USERS.stream().noneMatch(f.getClassName()::startsWith))
            .limit(FRAMES)
            .map(
                f ->
                    f.getClassName()
                        + "."
                        + f.getMethodName()
                        + "("
                        + f.getFileName()
                        + ":"
                        + f.getLineNumber()
                        + ")")
            .collect(Collectors.joining(", "));
    return thrown.getClass().getName()
        + (messageOf(thrown).isEmpty() ? "" : ": " + messageOf(thrown))
        + (frames.isEmpty() ? "" : " at " + frames);
  }

  /** {@code getMessage} is code of the component and may throw. */
  private static String messageOf(Throwable thrown) {
    try {
      String message = thrown.getMessage();
      return message == null ? "" : message;
    } catch (RuntimeException e) {
      return "(its message cannot be read: " + e.getClass().getName() + ")";
    }
  }
}
