package org.sitaf.agent.toolchain.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What a JVM prints of its threads when it gets {@code SIGQUIT}. */
final class ThreadDump {
  private static final int MOST_FRAMES = 6;
  private static final String FRAME = "\tat ";

  private ThreadDump() {}

  /**
   * Where the thread that runs the cases is: innermost call first, up to the test application's own
   * frames.
   */
  static Optional<String> componentStack(String dump) {
    List<String> frames = new ArrayList<>();
    boolean inMain = false;
    for (String line : dump.lines().toList()) {
      if (line.startsWith("\"main\" ")) {
        inMain = true;
        frames.clear();
      } else if (inMain && line.startsWith(FRAME)) {
        String frame = line.substring(FRAME.length());
        if (isOfTheTestApplication(frame) || frames.size() == MOST_FRAMES) {
          break;
        }
        frames.add(withoutModule(frame));
      } else if (inMain && line.isBlank()) {
        break;
      }
    }
    return frames.isEmpty() ? Optional.empty() : Optional.of(String.join(" < ", frames));
  }

  private static boolean isOfTheTestApplication(String frame) {
    return frame.startsWith("sitaf.harness.") || frame.startsWith("org.sitaf.runtime.");
  }

  /** {@code java.lang.Thread.sleep(java.base@17.0.15/Native Method)} says too much. */
  private static String withoutModule(String frame) {
    return frame.replaceAll("\\([a-z.]+@[^/)]*/", "(");
  }
}
