package org.sitaf.agent.executor;

/** Keeps the end of an error stream, where a crashed process wrote its report. */
final class ErrorTail {
  /** Larger than the reports of sanitizers with their stack traces. */
  private static final int MAX_LENGTH = 1 << 16;

  private final StringBuilder text = new StringBuilder();

  synchronized void add(String more) {
    text.append(more);
    if (text.length() > 2 * MAX_LENGTH) {
      text.delete(0, text.length() - MAX_LENGTH);
    }
  }

  synchronized String get() {
    return text.substring(Math.max(0, text.length() - MAX_LENGTH));
  }
}
