package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Programs of the system that walk through trees of any depth and shape, by descriptors and without
 * following links, as Java does not.
 */
public final class SystemTool {
  private static final int MOST_SAID = 2000;

  private SystemTool() {}

  /**
   * Runs one to its end.
   *
   * @throws IOException when it fails or takes longer, with what it says; it is gone then
   * @throws InterruptedException when nobody waits for it any more; it is gone then
   */
  public static void run(List<String> command, Duration atMost)
      throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.PIPE)
            .start();
    try {
      process.getOutputStream().close();
      // Reads on, or a tool with many complaints would wait for ever.
      StringBuilder said = new StringBuilder();
      Thread reader = new Thread(() -> read(process, said), "sitaf-system-tool");
      reader.setDaemon(true);
      reader.start();
      if (!process.waitFor(atMost.toMillis(), TimeUnit.MILLISECONDS)) {
        throw new IOException(
            command.get(0) + " takes longer than " + atMost.toSeconds() + " s and was given up");
      }
      reader.join(atMost.toMillis());
      if (process.exitValue() != 0) {
        synchronized (said) {
          throw new IOException(
              said.toString().lines().findFirst().orElse(command.get(0) + " failed"));
        }
      }
    } finally {
      process.destroyForcibly();
    }
  }

  private static void read(Process process, StringBuilder said) {
    byte[] buffer = new byte[4096];
    try (var in = process.getInputStream()) {
      for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
        synchronized (said) {
          if (said.length() < MOST_SAID) {
            said.append(new String(buffer, 0, n, StandardCharsets.UTF_8));
          }
        }
      }
    } catch (IOException e) {
      // It is gone.
    }
  }
}
