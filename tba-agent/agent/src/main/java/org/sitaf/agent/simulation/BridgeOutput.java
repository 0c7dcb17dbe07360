package org.sitaf.agent.simulation;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** Reads the error stream of a bridge and keeps its end, so that the bridge never blocks on it. */
final class BridgeOutput {
  private static final int KEPT = 4096;
  private static final long JOIN_MS = 500;

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
      // The process has ended.
    }
  }

  /** All that is kept, after the process has ended. */
  String text() {
    try {
      reader.join(JOIN_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    synchronized (kept) {
      return kept.toString().strip();
    }
  }

  /** The last line in parentheses, after the bridge has ended; empty without output. */
  String lastLine() {
    try {
      reader.join(JOIN_MS);
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
