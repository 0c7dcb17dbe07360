package org.sitaf.agent.sandbox;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;

/**
 * How a tool ended, and what it said.
 *
 * @param code its exit code; {@link #GIVEN_UP} when it took too long
 * @param output of its output stream, at most {@link #MAX_BYTES}
 * @param errors of its error stream, at most {@link #MAX_BYTES}; at its end the limit that it was
 *     ended for
 */
public record ToolEnd(int code, String output, String errors) {
  /** The code of a tool that took longer than it may. */
  public static final int GIVEN_UP = -1;

  /** What is kept of each stream; the rest is read and dropped. */
  public static final int MAX_BYTES = 8 << 20;

  private static final Duration OUTPUT_GRACE = Duration.ofSeconds(2);

  /** Whether it took longer than it may. */
  public boolean gaveUp() {
    return code == GIVEN_UP;
  }

  static ToolEnd of(ConfinedProcess process, Duration atMost) throws InterruptedException {
    try (process) {
      Stream output = new Stream(process.output());
      Stream errors = new Stream(process.errors());
      boolean ended = process.awaitEnd(atMost);
      if (!ended) {
        process.kill();
      }
      process.killRest();
      String said = errors.text();
      return new ToolEnd(
          ended ? process.exitCode() : GIVEN_UP,
          output.text(),
          process.brokenLimit().map(limit -> withLine(said, limit)).orElse(said));
    }
  }

  private static String withLine(String said, String limit) {
    String lineEnd = said.isEmpty() || said.endsWith("\n") ? "" : "\n";
    return said + lineEnd + "it was ended: " + limit + "\n";
  }

  /** One stream, read to its end so that the tool never waits for a full pipe. */
  private static final class Stream {
    private final ByteArrayOutputStream kept = new ByteArrayOutputStream();
    private final Thread reader;

    Stream(InputStream stream) {
      reader = new Thread(() -> read(stream), "sitaf-tool-output");
      reader.setDaemon(true);
      reader.start();
    }

    private void read(InputStream stream) {
      byte[] buffer = new byte[8192];
      try (stream) {
        for (int n = stream.read(buffer); n >= 0; n = stream.read(buffer)) {
          synchronized (kept) {
            kept.write(buffer, 0, Math.min(n, MAX_BYTES - kept.size()));
          }
        }
      } catch (IOException e) {
        // The tool is gone, and its output with it.
      }
    }

    String text() throws InterruptedException {
      reader.join(OUTPUT_GRACE.toMillis());
      synchronized (kept) {
        return kept.toString(StandardCharsets.UTF_8);
      }
    }
  }
}
