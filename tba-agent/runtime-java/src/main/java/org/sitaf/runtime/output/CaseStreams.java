package org.sitaf.runtime.output;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;

/**
 * Standard streams that mark which case printed what: the first output of each case follows a mark
 * with its number. Output of native code has no mark and is attributed to the previous case that
 * printed.
 */
public final class CaseStreams {
  private static final char MARK = '\u001e';

  /** Static because a process runs a single suite; null when the output has no marks. */
  private static volatile @Nullable CaseStreams installed;

  private final PrintStream out;
  private final PrintStream err;
  private volatile int current;

  private CaseStreams() {
    out = stream(FileDescriptor.out);
    err = stream(FileDescriptor.err);
  }

  /** Replaces System.out and System.err by streams with marks. */
  public static void install() {
    CaseStreams streams = new CaseStreams();
    System.setOut(streams.out);
    System.setErr(streams.err);
    installed = streams;
  }

  /**
   * Attributes the following output to a case.
   *
   * @param no from 1; 0 for output that belongs to no case
   */
  public static void begin(int no) {
    CaseStreams streams = installed;
    if (streams != null) {
      streams.out.flush();
      streams.err.flush();
      streams.current = no;
    }
  }

  private PrintStream stream(FileDescriptor descriptor) {
    return new PrintStream(
        new BufferedOutputStream(new Marked(new FileOutputStream(descriptor)), 8192),
        true,
        StandardCharsets.UTF_8);
  }

  /** Writes the marks. Guarded by the lock of its print stream. */
  private final class Marked extends OutputStream {
    private final FileOutputStream stream;
    private int announced;

    Marked(FileOutputStream stream) {
      this.stream = stream;
    }

    @Override
    public void write(int b) throws IOException {
      write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
      int no = current;
      if (no == announced || length == 0) {
        stream.write(bytes, offset, length);
        return;
      }
      announced = no;
      byte[] mark = (MARK + "case " + no + "\n").getBytes(StandardCharsets.US_ASCII);
      byte[] both = new byte[mark.length + length];
      System.arraycopy(mark, 0, both, 0, mark.length);
      System.arraycopy(bytes, offset, both, mark.length, length);
      stream.write(both);
    }
  }
}
