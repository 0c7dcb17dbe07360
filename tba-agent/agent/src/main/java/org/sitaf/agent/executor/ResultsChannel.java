package org.sitaf.agent.executor;

import java.io.ByteArrayOutputStream;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.concurrent.TimeUnit;

/**
 * What one test application writes about its cases: lines through a pipe that its own process holds
 * by a descriptor. Each line is {@code NUMBER TOKEN CONTENT}, numbered from 1. The token is known
 * to the agent and to the driver, so that other lines are found out. Holds at most one line,
 * whatever is written.
 */
final class ResultsChannel implements AutoCloseable {
  /** Longest line, in bytes. */
  static final int MAX_LINE = 1 << 20;

  private static final int TOKEN_BYTES = 16;
  private static final long PIPE_SECONDS = 10;
  private static final SecureRandom RANDOM = new SecureRandom();

  private final Path pipe;
  private final RandomAccessFile file;
  private final FileInputStream input;
  private final String token;
  private final byte[] buffer = new byte[64 * 1024];
  private final ByteArrayOutputStream incomplete = new ByteArrayOutputStream();
  private boolean cut;
  private long next = 1;

  /** Is given the lines in their order. */
  interface Lines {
    /** The test application is ready to begin its first case. */
    void ready();

    /** A numbered line. */
    void content(String text);

    /** A numbered line of more than {@link #MAX_LINE} bytes. */
    void tooLong();

    /**
     * Something that no test application writes.
     *
     * @param bytes that were written
     */
    void suspicious(String reason, int bytes);

    /** So many bytes of a line were left out, which is too long. */
    void leftOut(int bytes);

    /** Whether no further line is wanted. */
    boolean isFull();
  }

  private ResultsChannel(Path pipe, RandomAccessFile file) throws IOException {
    this.pipe = pipe;
    this.file = file;
    this.input = new FileInputStream(file.getFD());
    byte[] random = new byte[TOKEN_BYTES];
    RANDOM.nextBytes(random);
    this.token = HexFormat.of().formatHex(random);
  }

  /**
   * Makes the pipe in a folder that the test application does not see.
   *
   * @throws IOException if this machine cannot make one
   */
  static ResultsChannel open(Path folder) throws IOException, InterruptedException {
    Path pipe = Files.createTempDirectory(folder, "results").resolve("pipe");
    // A process with the descriptor may open it again for writing, as a JVM must, and not read it.
    Process made =
        new ProcessBuilder("mkfifo", "-m", "622", pipe.toString())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    if (!made.waitFor(PIPE_SECONDS, TimeUnit.SECONDS) || made.exitValue() != 0) {
      made.destroyForcibly();
      throw new IOException(
          "mkfifo could not make the pipe for results in " + folder + "; it comes with coreutils");
    }
    // For both ways, so that it opens before anybody else has, and has no end while this is open.
    return new ResultsChannel(pipe, new RandomAccessFile(pipe.toFile(), "rw"));
  }

  Path pipe() {
    return pipe;
  }

  String token() {
    return token;
  }

  /**
   * Gives what was written since the last call, without waiting; true when there was anything that
   * the test application itself wrote.
   */
  boolean read(Lines lines) throws IOException {
    long before = next;
    while (input.available() > 0 && !lines.isFull()) {
      int read = input.read(buffer);
      int from = 0;
      for (int i = 0; i < read; i++) {
        if (buffer[i] == '\n') {
          keep(from, i, lines);
          line(lines);
          from = i + 1;
        }
      }
      keep(from, read, lines);
    }
    return next > before;
  }

  /** How many bytes of a line are there that has not come to its end. */
  int torn() {
    return incomplete.size();
  }

  private void keep(int from, int to, Lines lines) {
    int kept = Math.min(to - from, MAX_LINE - incomplete.size());
    incomplete.write(buffer, from, kept);
    if (kept < to - from) {
      cut = true;
      lines.leftOut(to - from - kept);
    }
  }

  private void line(Lines lines) {
    int length = incomplete.size();
    if (length <= token.length()) {
      incomplete.reset();
      lines.suspicious("a line without number and token", length + 1);
      return;
    }
    String line = incomplete.toString(StandardCharsets.UTF_8);
    boolean whole = !cut;
    incomplete.reset();
    cut = false;
    int space = line.indexOf(' ');
    int content = space + token.length() + 2;
    if (space < 1
        || space > 18
        || line.length() < content
        || !line.startsWith(token, space + 1)
        || line.charAt(content - 1) != ' ') {
      lines.suspicious("a line without number and token", length + 1);
      return;
    }
    long number = number(line, space);
    if (number != next) {
      lines.suspicious("line " + number + " came where line " + next + " was due", length + 1);
      if (number < next) {
        return;
      }
    }
    if (next == 1) {
      hide();
    }
    next = number + 1;
    if (!whole) {
      lines.tooLong();
    } else if (line.length() == content) {
      lines.ready();
    } else {
      lines.content(line.substring(content));
    }
  }

  /** The number before the space; -1 where there is none. */
  private static long number(String line, int space) {
    long number = 0;
    for (int i = 0; i < space; i++) {
      int digit = line.charAt(i) - '0';
      if (digit < 0 || digit > 9) {
        return -1;
      }
      number = 10 * number + digit;
    }
    return number;
  }

  /** Takes the name away; without a sandbox a component could find it. */
  private void hide() {
    try {
      Files.deleteIfExists(pipe);
      Files.deleteIfExists(pipe.getParent());
    } catch (IOException e) {
      // The build's folder is deleted as a whole.
    }
  }

  /** Closes the pipe; what is still in it is gone. */
  @Override
  public void close() {
    hide();
    try {
      file.close();
    } catch (IOException e) {
      // Nothing was written to it here.
    }
  }
}
