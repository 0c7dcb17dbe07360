package org.sitaf.agent.executor;

/**
 * Remembers the last telling line of a stream: the last that is neither blank nor indented, because
 * a stack trace's indented lines say less than its head. Bounded, whatever the stream holds.
 */
final class LastWords {
  private static final int MAX_LENGTH = 500;

  private final StringBuilder line = new StringBuilder();
  private String telling = "";

  synchronized void add(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\n' || c == '\r') {
        endLine();
      } else if (line.length() < MAX_LENGTH) {
        line.append(c);
      }
    }
  }

  synchronized String get() {
    endLine();
    return telling;
  }

  private void endLine() {
    String text = line.toString();
    line.setLength(0);
    if (!text.isBlank() && !Character.isWhitespace(text.charAt(0))) {
      telling = text.strip();
    }
  }
}
