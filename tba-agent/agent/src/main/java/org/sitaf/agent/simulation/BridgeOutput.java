package org.sitaf.agent.simulation;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** The end of what a bridge writes to its error stream, which is read so that it never waits. */
final class BridgeOutput {
  private static final int KEPT = 4096;
  private static final long LAST_MS = 500;

  private final StringBuilder kept = new StringBuilder();
  private final Thread reader;

  BridgeOutput(InputStream stream) {
    reader = new Thread(() -> read(stream), "sitaf-bridge-errors");
    reader.setDaemon(true);
    reader.start();
  }

  private void read(InputStream stream) {
    byte[] buffer = new byte[KEPT];
    try (stream) {
      for (int n = stream.read(buffer); n >= 0; n = stream.read(buffer)) {
        synchronized (kept) {
          kept.append(new String(buffer, 0, n, StandardCharsets.ISO_8859_1));
          kept.delete(0, Math.max(0, kept.length() - KEPT));
        }
      }
    } catch (IOException e) {
      // The process is gone, and its output with it.
    }
  }

  /** The last line after the bridge's end, in brackets; empty where it said nothing. */
  String lastLine() {
    try {
      reader.join(LAST_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    synchronized (kept) {
      return kept.toString()
          .lines()
          .filter(line -> !line.isBlank())
          .reduce((earlier, later) -> later)
          .map(line -> " (" + line.strip() + ")")
          .orElse("");
    }
  }
}
