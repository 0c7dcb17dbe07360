package org.sitaf.runtime.suite;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Where the results go, one line a case. Each line is handed to the kernel in one write the moment
 * its case ends, so that the end of the process, however sudden, loses none of them.
 */
public final class ResultsFile implements AutoCloseable {
  private final FileChannel channel;

  private ResultsFile(FileChannel channel) {
    this.channel = channel;
  }

  /** Begins a new file; one that is there is emptied. */
  public static ResultsFile create(Path file) throws IOException {
    return new ResultsFile(
        FileChannel.open(
            file,
            StandardOpenOption.CREATE,
            StandardOpenOption.WRITE,
            StandardOpenOption.TRUNCATE_EXISTING));
  }

  /**
   * Goes on with a file, behind what is in it. A last line that a killed process left unfinished is
   * ended first.
   */
  public static ResultsFile append(Path file) throws IOException {
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    long end = channel.size();
    if (end > 0) {
      ByteBuffer last = ByteBuffer.allocate(1);
      channel.read(last, end - 1);
      channel.position(end);
      if (last.get(0) != '\n') {
        channel.write(ByteBuffer.wrap(new byte[] {'\n'}));
      }
    }
    return new ResultsFile(channel);
  }

  /**
   * Writes an empty line: all is set up, and the first case begins. From then on the time limit of
   * a case holds.
   */
  public void ready() throws IOException {
    channel.write(ByteBuffer.wrap(new byte[] {'\n'}));
  }

  /** Writes the line of a case. */
  public void save(CaseResult result) throws IOException {
    ByteBuffer line = ByteBuffer.wrap(result.line().getBytes(StandardCharsets.UTF_8));
    while (line.hasRemaining()) {
      channel.write(line);
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
