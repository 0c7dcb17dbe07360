package org.sitaf.core.expression;

/**
 * Computes the size of a regular expression with expanded repetitions. RE2 expands repetitions
 * before it checks any limit: {@code ((a{1000}){1000}){1000}} has a size of one billion.
 */
final class PatternSize {
  private final String pattern;
  private int at;
  private int depth;

  private PatternSize(String pattern) {
    this.pattern = pattern;
  }

  /**
   * Returns an upper bound close to the real size, or a huge number if the pattern is nested too
   * deeply.
   */
  static long of(String pattern) {
    return new PatternSize(pattern).alternatives();
  }

  private long alternatives() {
    if (++depth > ExpressionLimits.MAX_DEPTH) {
      at = pattern.length();
      return Long.MAX_VALUE / 4;
    }
    long size = 1;
    long atom = 0;
    while (at < pattern.length()) {
      char c = pattern.charAt(at++);
      if (c == ')') {
        break;
      }
      if (c == '{' && atom > 0) {
        // The atom itself is already counted once.
        size = sum(size, product(atom, repetitions() - 1));
        continue;
      }
      atom = c == '(' ? alternatives() : atom(c);
      size = sum(size, atom);
    }
    depth--;
    return size;
  }

  /** Reads one character, character class or operator. */
  private long atom(char c) {
    if (c == '\\' && at < pattern.length()) {
      char escaped = pattern.charAt(at++);
      if ("pPx".indexOf(escaped) >= 0 && at < pattern.length() && pattern.charAt(at) == '{') {
        at = after('}');
      }
    } else if (c == '[') {
      // A closing bracket right after the opening one or the negation is an ordinary character.
      at += at < pattern.length() && pattern.charAt(at) == '^' ? 1 : 0;
      at += at < pattern.length() && pattern.charAt(at) == ']' ? 1 : 0;
      while (at < pattern.length() && pattern.charAt(at) != ']') {
        if (pattern.startsWith("[:", at)) {
          at = after(']') - 1;
        }
        at += pattern.charAt(at) == '\\' ? 2 : 1;
      }
      at = Math.min(pattern.length(), at + 1);
    }
    return 1;
  }

  /** Reads the larger number of {@code {2,5}}; 1 if it is not a repetition. */
  private long repetitions() {
    int end = after('}');
    long most = 1;
    for (String number : pattern.substring(at, Math.max(at, end - 1)).split(",", -1)) {
      if (number.isEmpty()) {
        continue;
      }
      if (number.length() > 6 || !number.chars().allMatch(c -> c >= '0' && c <= '9')) {
        return 1;
      }
      most = Math.max(most, Long.parseLong(number));
    }
    at = end;
    return most;
  }

  private int after(char close) {
    int end = pattern.indexOf(close, at);
    return end < 0 ? pattern.length() : end + 1;
  }

  private static long sum(long a, long b) {
    return Math.min(Long.MAX_VALUE / 4, a + b);
  }

  private static long product(long a, long b) {
    return b != 0 && a > Long.MAX_VALUE / 4 / b ? Long.MAX_VALUE / 4 : a * b;
  }
}
