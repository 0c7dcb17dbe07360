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
 * The results that one test application writes: lines through a pipe that only its process has
 * open. Each line is {@code NUMBER TOKEN CONTENT}, numbered from 1. Only the agent and the driver
 * know the token, which exposes forged lines. Buffers at most one line.
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

  /** Receives the lines in order. */
  interface Lines {
    /** The test application is ready for its first case. */
    void ready();

    /** A numbered line. */
    void content(String text);

    /** A numbered line that exceeds {@link #MAX_LINE} bytes. */
    void tooLong();

    /**
     * A line that no test application writes.
     *
     * @param length number of bytes
     */
    void suspicious(String reason, int bytes);

    /** Bytes of a line that was too long were discarded. */
    void omitted(int bytes);

    /** Whether reading has to stop. */
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
   * Creates the pipe in a folder that the test application cannot see.
   *
   * @throws IOException if the pipe cannot be created
   */
  static ResultsChannel open(Path folder) throws IOException, InterruptedException {
    Path pipe = Files.createTempDirectory(folder, "results").resolve("pipe");
    // Mode 622: a process with the descriptor may reopen it for writing, as a JVM does, but not
    // read it.
    Process made =
        new ProcessBuilder("mkfifo", "-m", "622", pipe.toString())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    if (!made.waitFor(PIPE_SECONDS, TimeUnit.SECONDS) || made.exitValue() != 0) {
      made.destroyForcibly();
      throw new IOException(
          "mkfifo could not create the pipe for results in "
              + folder
              + "; it is part of coreutils");
    }
    // Opened for both directions, so that opening does not block and reads never hit the end.
    return new ResultsChannel(pipe, new RandomAccessFile(pipe.toFile(), "rw"));
  }

  Path pipe() {
    return pipe;
  }

  String token() {
    return token;
  }

  /**
   * Passes on what was written since the last call, without waiting; returns whether the test
   * application itself wrote anything.
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

  /** Number of bytes of an incomplete line. */
  int torn() {
    return incomplete.size();
  }

  private void keep(int from, int to, Lines lines) {
    int kept = Math.min(to - from, MAX_LINE - incomplete.size());
    incomplete.write(buffer, from, kept);
    if (kept < to - from) {
      cut = true;
      lines.omitted(to - from - kept);
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
      lines.suspicious("got line " + number + ", expected line " + next, length + 1);
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

  /** The number before the space; -1 if there is none. */
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

  /** Deletes the file name, which a component without a sandbox could open. */
  private void hide() {
    try {
      Files.deleteIfExists(pipe);
      Files.deleteIfExists(pipe.getParent());
    } catch (IOException e) {
      // The folder is deleted at the end of the build.
    }
  }

  /** Closes the pipe and discards its content. */
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
