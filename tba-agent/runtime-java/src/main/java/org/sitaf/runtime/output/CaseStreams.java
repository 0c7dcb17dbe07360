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
 * The standard streams of the process, in which stands whose output follows: before the first
 * output of a case its mark. A case that prints nothing costs nothing. What native code writes past
 * Java belongs to the case that printed before it.
 */
public final class CaseStreams {
  private static final char MARK = '\u001e';

  /** A process runs one suite; null where nobody reads its streams case by case. */
  private static volatile @Nullable CaseStreams installed;

  private final PrintStream out;
  private final PrintStream err;
  private volatile int current;

  private CaseStreams() {
    out = stream(FileDescriptor.out);
    err = stream(FileDescriptor.err);
  }

  /** Has System.out and System.err say from now on which case prints. */
  public static void install() {
    CaseStreams streams = new CaseStreams();
    System.setOut(streams.out);
    System.setErr(streams.err);
    installed = streams;
  }

  /**
   * What is printed from now on is printed by this case.
   *
   * @param no from 1; 0 for what belongs to no case
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

  /** Used under the lock of its print stream alone. */
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
