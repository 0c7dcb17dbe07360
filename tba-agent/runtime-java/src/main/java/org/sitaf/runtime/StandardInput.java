package org.sitaf.runtime;

import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;

/** Reads the line that the agent writes to the standard input of a test application. */
final class StandardInput {
  private static final int MAX_LENGTH = 1024;

  private StandardInput() {}

  /** The line without its line feed; null when the input ends without one. */
  static @Nullable String line() {
    StringBuilder line = new StringBuilder();
    // Not closed and not buffered: the input after the line belongs to the component.
    FileInputStream input = new FileInputStream(FileDescriptor.in);
    try {
      for (int c = input.read(); c != '\n'; c = input.read()) {
        if (c < 0 || line.length() == MAX_LENGTH) {
          return null;
        }
        line.append((char) c);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return line.toString();
  }
}
