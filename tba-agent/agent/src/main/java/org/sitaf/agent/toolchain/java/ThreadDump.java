package org.sitaf.agent.toolchain.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Parses the thread dump that a JVM prints for {@code SIGQUIT}. */
final class ThreadDump {
  private static final int MAX_FRAMES = 6;
  private static final String FRAME = "\tat ";

  private ThreadDump() {}

  /**
   * The stack of the thread that runs the cases, innermost call first, without the frames of the
   * test application.
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
        if (isOfTheTestApplication(frame) || frames.size() == MAX_FRAMES) {
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

  /** Removes the module, as in {@code java.lang.Thread.sleep(java.base@17.0.15/Native Method)}. */
  private static String withoutModule(String frame) {
    return frame.replaceAll("\\([a-z.]+@[^/)]*/", "(");
  }
}
