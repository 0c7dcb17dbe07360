package org.sitaf.agent.build;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.OutputSink;

/**
 * The log of a build: a file and a listener. Limits the output of a component, including the
 * headers {@code [sitaf] case NO} before it, and the agent's remarks, because a component can cause
 * many of them. Remarks at the end of the build have a separate limit.
 */
public final class BuildLog implements OutputSink, AutoCloseable {
  /** More output than people read; an endless loop prints more than this in a second. */
  static final long OUTPUT_LIMIT_BYTES = 4L << 20;

  /** Limit for the remarks during the build, and the same again for those at its end. */
  static final long REMARKS_LIMIT_BYTES = 1L << 20;

  /** Maximum length of a remark. */
  static final int MAX_REMARK_LENGTH = 4000;

  private final OutputStream file;
  private final BuildListener listener;
  private long output;
  private long remarks;
  private long conclusions;
  private boolean atLineStart = true;
  private int headed;
  private boolean cut;
  private @Nullable IOException failure;

  /**
   * Creates the file.
   *
   * @param listener gets what is appended
   */
  public BuildLog(Path path, BuildListener listener) throws IOException {
    // Not a channel, which would be closed by the interrupt of a cancelled build.
    this.file = new FileOutputStream(path.toFile());
    this.listener = listener;
  }

  @Override
  public synchronized void output(String text, int caseNo) {
    if (cut) {
      return;
    }
    if (caseNo != headed) {
      // Test applications may run in parallel: print a header whenever the case changes.
      output += append(line(caseNo == 0 ? "outside of cases" : "case " + caseNo));
      headed = caseNo;
    }
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    output += bytes.length;
    if (output > OUTPUT_LIMIT_BYTES) {
      cut = true;
      append(
          line(
              "the output of the test application is cut here, because it exceeds "
                  + (OUTPUT_LIMIT_BYTES >> 20)
                  + " MiB"));
    } else {
      append(bytes);
    }
  }

  @Override
  public synchronized void remark(String line) {
    remarks = limited(line, remarks);
  }

  /** Like {@link #remark}, at the end of the build; not affected by earlier remarks. */
  synchronized void conclude(String line) {
    conclusions = limited(line, conclusions);
  }

  /** Appends a line unless the limit is exceeded; returns the new total. */
  private long limited(String line, long before) {
    if (before > REMARKS_LIMIT_BYTES) {
      return before;
    }
    long after = before + append(line(line));
    if (after > REMARKS_LIMIT_BYTES) {
      append(
          line(
              "further remarks are omitted, because they exceed "
                  + (REMARKS_LIMIT_BYTES >> 20)
                  + " MiB"));
    }
    return after;
  }

  private byte[] line(String text) {
    String shown =
        text.length() <= MAX_REMARK_LENGTH ? text : text.substring(0, MAX_REMARK_LENGTH) + "...";
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
   * Closes the log.
   *
   * @throws IOException also for an earlier write error: callers that write output cannot handle
   *     errors and must continue, or the test application would block
   */
  @Override
  public synchronized void close() throws IOException {
    file.close();
    if (failure != null) {
      throw new IOException("the build's log cannot be written: " + failure.getMessage(), failure);
    }
  }
}
