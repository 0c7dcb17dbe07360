package org.sitaf.agent.build;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.OutputSink;

/**
 * The log of a build: a file, and a listener. What a component prints is bounded, with the lines
 * that say whose output follows: {@code [sitaf] case NO}. So are the agent's remarks, as a
 * component can cause many; what the agent says at the end of the build has an allowance of its
 * own.
 */
final class BuildLog implements OutputSink, AutoCloseable {
  /** What people may still want to read; a component in an endless loop prints more in a second. */
  static final long OUTPUT_LIMIT_BYTES = 4L << 20;

  /** Of the remarks while the build runs, and again of those at its end. */
  static final long REMARKS_LIMIT_BYTES = 1L << 20;

  /** Of one remark. */
  static final int LONGEST_REMARK = 4000;

  private final OutputStream file;
  private final BuildListener listener;
  private long output;
  private long remarks;
  private long conclusions;
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
      // Test applications may run side by side: whenever another case prints it is named again.
      output += append(line(caseNo == 0 ? "outside of cases" : "case " + caseNo));
      headed = caseNo;
    }
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    output += bytes.length;
    if (output > OUTPUT_LIMIT_BYTES) {
      cut = true;
      append(
          line(
              "output of the test application is cut here: it is more than "
                  + (OUTPUT_LIMIT_BYTES >> 20)
                  + " MiB"));
    } else {
      append(bytes);
    }
  }

  @Override
  public synchronized void remark(String line) {
    remarks = bounded(line, remarks);
  }

  /** As {@link #remark}, of how the build ended: there is room for it, whatever was said before. */
  synchronized void conclude(String line) {
    conclusions = bounded(line, conclusions);
  }

  /** Says it, unless too much was said already; returns how much that is now. */
  private long bounded(String line, long before) {
    if (before > REMARKS_LIMIT_BYTES) {
      return before;
    }
    long after = before + append(line(line));
    if (after > REMARKS_LIMIT_BYTES) {
      append(
          line(
              "further remarks are left out: there are more than "
                  + (REMARKS_LIMIT_BYTES >> 20)
                  + " MiB"));
    }
    return after;
  }

  private byte[] line(String text) {
    String shown =
        text.length() <= LONGEST_REMARK ? text : text.substring(0, LONGEST_REMARK) + "...";
    return ((atLineStart ? "" : "\n") + "[sitaf] " + shown + "\n").getBytes(StandardCharsets.UTF_8);
  }

  private int append(byte[] bytes) {
    if (bytes.length == 0) {
      return 0;
    }
    atLineStart = bytes[bytes.length - 1] == '\n';
    try {
      file.write(bytes);
    } catch (IOException e) {
      failure = failure == null ? e : failure;
      return bytes.length;
    }
    listener.log(bytes);
    return bytes.length;
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
