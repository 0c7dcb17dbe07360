package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Runs system programs that handle trees of any depth and shape by descriptors, without following
 * links. Java cannot do that.
 */
public final class SystemTool {
  private static final int MAX_OUTPUT = 2000;

  private SystemTool() {}

  /**
   * Runs a program until it ends.
   *
   * @throws IOException if it fails or exceeds its time, with its first line of output; it is
   *     killed
   * @throws InterruptedException if the thread is interrupted; the program is killed
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
      // Read all output, so that the program never blocks on a full pipe.
      StringBuilder output = new StringBuilder();
      Thread reader = new Thread(() -> read(process, output), "sitaf-system-tool");
      reader.setDaemon(true);
      reader.start();
      if (!process.waitFor(atMost.toMillis(), TimeUnit.MILLISECONDS)) {
        throw new IOException(
            command.get(0) + " did not end within " + atMost.toSeconds() + " s and was killed");
      }
      reader.join(atMost.toMillis());
      if (process.exitValue() != 0) {
        synchronized (output) {
          throw new IOException(
              output.toString().lines().findFirst().orElse(command.get(0) + " failed"));
        }
      }
    } finally {
      process.destroyForcibly();
    }
  }

  private static void read(Process process, StringBuilder output) {
    byte[] buffer = new byte[4096];
    try (var in = process.getInputStream()) {
      for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
        synchronized (output) {
          if (output.length() < MAX_OUTPUT) {
            output.append(new String(buffer, 0, n, StandardCharsets.UTF_8));
          }
        }
      }
    } catch (IOException e) {
      // The program has ended.
    }
  }
}
