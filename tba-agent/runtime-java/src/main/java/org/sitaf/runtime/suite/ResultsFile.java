package org.sitaf.runtime.suite;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * The output file for results, with one line per case. Each line is written in one call when its
 * case ends, so a killed process loses no results.
 *
 * <p>When the output is a descriptor that the agent opened, each line starts with its number and a
 * secret token of the agent, so that output of the component is not mistaken for a result.
 */
public final class ResultsFile implements AutoCloseable {
  /** Maximum number of results that a power failure loses; a killed process loses none. */
  private static final int LINES_TO_SYNC = 4096;

  private static final String DESCRIPTOR = "fd:";

  /** Capacity for number and token. */
  private static final int PREFIX_LENGTH = 64;

  /** Not a FileChannel, because an interrupt from the component would close it. */
  private final FileOutputStream file;

  private final boolean numbered;
  private String token = "";
  private long number;
  private int unsynced;

  private ResultsFile(FileOutputStream file, boolean numbered) {
    this.file = file;
    this.numbered = numbered;
  }

  /**
   * Opens the output that {@code --results} names.
   *
   * @param append whether to append to an existing file
   */
  public static ResultsFile open(String results, boolean append) throws IOException {
    if (results.startsWith(DESCRIPTOR)) {
      String descriptor = results.substring(DESCRIPTOR.length());
      try {
        Integer.parseUnsignedInt(descriptor);
      } catch (NumberFormatException e) {
        throw new IOException("--results: '" + results + "' is not a descriptor such as fd:3", e);
      }
      return new ResultsFile(new FileOutputStream("/dev/fd/" + descriptor), true);
    }
    try {
      Path path = Path.of(results);
      return append ? append(path) : create(path);
    } catch (InvalidPathException e) {
      throw new IOException("--results: '" + results + "' is not a path", e);
    }
  }

  /** Creates a file; an existing file is truncated. */
  public static ResultsFile create(Path file) throws IOException {
    return new ResultsFile(new FileOutputStream(file.toFile()), false);
  }

  /** Appends to a file. An incomplete last line from a killed process is terminated first. */
  public static ResultsFile append(Path file) throws IOException {
    boolean incomplete = false;
    try (RandomAccessFile before = new RandomAccessFile(file.toFile(), "rw")) {
      if (before.length() > 0) {
        before.seek(before.length() - 1);
        incomplete = before.read() != '\n';
      }
    }
    FileOutputStream appended = new FileOutputStream(file.toFile(), true);
    if (incomplete) {
      appended.write('\n');
    }
    return new ResultsFile(appended, false);
  }

  /**
   * Reads the token if the output is a descriptor of the agent.
   *
   * @param line reads the line with the token, or returns null; called only for a descriptor
   * @throws IOException when there is no token
   */
  public void authorise(Supplier<@Nullable String> line) throws IOException {
    if (numbered) {
      String given = line.get();
      if (given == null || given.isBlank()) {
        throw new IOException("standard input holds no line with the token of the results");
      }
      token = given.strip();
    }
  }

  /**
   * Writes an empty line, which reports that set-up is complete. The agent then applies the time
   * limit of a case.
   */
  public void ready() throws IOException {
    write("\n");
  }

  /** Writes the line of a case. */
  public void save(CaseResult result) throws IOException {
    write(result.line());
    if (!numbered && ++unsynced >= LINES_TO_SYNC) {
      unsynced = 0;
      file.getFD().sync();
    }
  }

  private void write(String line) throws IOException {
    // The first use of + on strings is slow, because the JVM generates code for it.
    StringBuilder whole = new StringBuilder(line.length() + PREFIX_LENGTH);
    if (numbered) {
      whole.append(++number).append(' ').append(token).append(' ');
    }
    file.write(whole.append(line).toString().getBytes(StandardCharsets.UTF_8));
  }

  /** Syncs a file to the disk and closes it. */
  @Override
  public void close() throws IOException {
    try (file) {
      if (!numbered) {
        file.getFD().sync();
      }
    }
  }
}
