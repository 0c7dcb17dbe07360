package org.sitaf.agent.sandbox;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;

/**
 * Exit code and output of a tool.
 *
 * @param code exit code; {@link #TIMED_OUT} if the tool exceeded its time
 * @param output its output stream, at most {@link #MAX_BYTES}
 * @param errors its error stream, at most {@link #MAX_BYTES}, followed by the exceeded limit if the
 *     tool was killed for one
 */
public record ToolResult(int code, String output, String errors) {
  /** The code of a tool that exceeded its time. */
  public static final int TIMED_OUT = -1;

  /** Limit for each stream; the rest is discarded. */
  public static final int MAX_BYTES = 8 << 20;

  private static final Duration OUTPUT_GRACE = Duration.ofSeconds(2);

  /** Whether the tool exceeded its time. */
  public boolean timedOut() {
    return code == TIMED_OUT;
  }

  static ToolResult of(ConfinedProcess process, Duration atMost) throws InterruptedException {
    try (process) {
      Stream output = new Stream(process.output());
      Stream errors = new Stream(process.errors());
      boolean ended = process.awaitEnd(atMost);
      if (!ended) {
        process.kill();
      }
      process.killLeftovers();
      String errorText = errors.text();
      return new ToolResult(
          ended ? process.exitCode() : TIMED_OUT,
          output.text(),
          process.exceededLimit().map(limit -> withLine(errorText, limit)).orElse(errorText));
    }
  }

  private static String withLine(String text, String limit) {
    String lineEnd = text.isEmpty() || text.endsWith("\n") ? "" : "\n";
    return text + lineEnd + "it was killed: " + limit + "\n";
  }

  /** Reads a stream to its end, so that the tool never blocks on a full pipe. */
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
        // The tool was killed and its output is closed.
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
