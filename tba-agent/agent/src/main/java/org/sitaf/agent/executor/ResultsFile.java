package org.sitaf.agent.executor;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;

/** Reads the lines that a test application appends to its results file, while it does so. */
final class ResultsFile implements AutoCloseable {
  private static final int MAX_LINE = 1 << 20;

  private final Path path;
  private final FileChannel channel;
  private final ByteBuffer buffer = ByteBuffer.allocate(64 * 1024);
  private final ByteArrayOutputStream incomplete = new ByteArrayOutputStream();
  private long position;

  /** Makes the file, empty. */
  ResultsFile(Path path) throws IOException {
    this.path = path;
    Files.write(path, new byte[0]);
    this.channel = FileChannel.open(path, StandardOpenOption.READ);
  }

  Path path() {
    return path;
  }

  /** The lines that were completed since the last call; an empty line is among them as such. */
  List<String> newLines() throws IOException {
    List<String> lines = new ArrayList<>();
    while (true) {
      buffer.clear();
      int read = channel.read(buffer, position);
      if (read <= 0) {
        return lines;
      }
      position += read;
      byte[] bytes = buffer.array();
      int from = 0;
      for (int i = 0; i < read; i++) {
        if (bytes[i] == '\n') {
          keep(bytes, from, i);
          lines.add(incomplete.toString(StandardCharsets.UTF_8));
          incomplete.reset();
          from = i + 1;
        }
      }
      keep(bytes, from, read);
    }
  }

  private void keep(byte[] bytes, int from, int to) {
    incomplete.write(bytes, from, Math.min(to - from, MAX_LINE - incomplete.size()));
  }

  /**
   * Drops a line that a process began and did not live to complete, so that the next process
   * appends to a clean end.
   */
  void dropIncompleteLine() throws IOException {
    if (incomplete.size() > 0) {
      incomplete.reset();
      try (FileChannel writer = FileChannel.open(path, StandardOpenOption.WRITE)) {
        writer.position(position);
        writer.write(ByteBuffer.wrap(new byte[] {'\n'}));
      }
      position++;
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
