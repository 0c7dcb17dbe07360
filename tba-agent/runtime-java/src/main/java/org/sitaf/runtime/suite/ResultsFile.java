package org.sitaf.runtime.suite;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Where the results go, one line a case. Each line is handed to the kernel in one write the moment
 * its case ends, so that the end of the process, however sudden, loses none of them.
 */
public final class ResultsFile implements AutoCloseable {
  /** How many results a machine may lose with its power; a process that is killed loses none. */
  private static final int LINES_TO_SYNC = 4096;

  /** Not a channel: an interrupt that the component left behind would close it. */
  private final FileOutputStream file;

  private int unsynced;

  private ResultsFile(FileOutputStream file) {
    this.file = file;
  }

  /** Begins a new file; one that is there is emptied. */
  public static ResultsFile create(Path file) throws IOException {
    return new ResultsFile(new FileOutputStream(file.toFile()));
  }

  /**
   * Goes on with a file, behind what is in it. A last line that a killed process left unfinished is
   * ended first.
   */
  public static ResultsFile append(Path file) throws IOException {
    boolean torn = false;
    try (RandomAccessFile before = new RandomAccessFile(file.toFile(), "rw")) {
      if (before.length() > 0) {
        before.seek(before.length() - 1);
        torn = before.read() != '\n';
      }
    }
    FileOutputStream appended = new FileOutputStream(file.toFile(), true);
    if (torn) {
      appended.write('\n');
    }
    return new ResultsFile(appended);
  }

  /**
   * Writes an empty line: all is set up, and the first case begins. From then on the time limit of
   * a case holds.
   */
  public void ready() throws IOException {
    file.write('\n');
  }

  /** Writes the line of a case. */
  public void save(CaseResult result) throws IOException {
    file.write(result.line().getBytes(StandardCharsets.UTF_8));
    if (++unsynced >= LINES_TO_SYNC) {
      unsynced = 0;
      file.getFD().sync();
    }
  }

  /** Hands the rest to the disk and closes. */
  @Override
  public void close() throws IOException {
    try (file) {
      file.getFD().sync();
    }
  }
}
