package org.sitaf.agent.build;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.OutputSink;

/**
 * The log of a build: a file, and whoever listens. What a component prints is bounded; the agent's
 * remarks are always there, among them whose output follows: {@code [sitaf] case NO}.
 */
final class BuildLog implements OutputSink, AutoCloseable {
  /** What people may still want to read; a component in an endless loop prints more in a second. */
  static final long OUTPUT_LIMIT_BYTES = 4L << 20;

  private final OutputStream file;
  private final BuildListener listener;
  private long output;
  private boolean atLineStart = true;
  private int headed;
  private boolean cut;
  private @Nullable IOException failure;

  BuildLog(Path path, BuildListener listener) throws IOException {
    // Not a channel: the interrupt of a cancelled build would close it.
    this.file = new FileOutputStream(path.toFile());
    this.listener = listener;
  }

  @Override
  public synchronized void output(String text, int caseNo) {
    if (cut) {
      return;
    }
    if (caseNo != headed) {
      // Test applications may run side by side: whenever another case prints it is named anew.
      remark(caseNo == 0 ? "outside of cases" : "case " + caseNo);
      headed = caseNo;
    }
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    output += bytes.length;
    if (output > OUTPUT_LIMIT_BYTES) {
      cut = true;
      remark(
          "output of the test application is cut here: it is more than "
              + (OUTPUT_LIMIT_BYTES >> 20)
              + " MiB");
    } else {
      append(bytes);
    }
  }

  @Override
  public synchronized void remark(String line) {
    append(((atLineStart ? "" : "\n") + "[sitaf] " + line + "\n").getBytes(StandardCharsets.UTF_8));
  }

  private void append(byte[] bytes) {
    if (bytes.length == 0) {
      return;
    }
    atLineStart = bytes[bytes.length - 1] == '\n';
    try {
      file.write(bytes);
    } catch (IOException e) {
      failure = failure == null ? e : failure;
      return;
    }
    listener.log(bytes);
  }

  /**
   * Ends the log.
   *
   * @throws IOException also when something could not be written before: whoever tells of output
   *     cannot do anything about it, and must go on, or the test application would wait
   */
  @Override
  public synchronized void close() throws IOException {
    file.close();
    if (failure != null) {
      throw new IOException("the build's log cannot be written: " + failure.getMessage(), failure);
    }
  }
}
