package org.sitaf.agent.executor;

/**
 * Keeps the last relevant line of a stream: the last one that is neither blank nor indented,
 * because the indented lines of a stack trace say less than its head. Limited in length.
 */
final class LastLine {
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
