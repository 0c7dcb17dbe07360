package org.sitaf.core.trajectory;

/** Finds words, matching parentheses and positions in the text of a formula. Skips CEL strings. */
final class FormulaText {
  private final String text;

  FormulaText(String text) {
    this.text = text;
  }

  /** The position after white space and comments. */
  int skipSpace(int from) {
    int at = from;
    while (at < text.length()) {
      if (text.startsWith("//", at)) {
        int end = text.indexOf('\n', at);
        at = end < 0 ? text.length() : end;
      } else if (Character.isWhitespace(text.charAt(at))) {
        at++;
      } else {
        break;
      }
    }
    return at;
  }

  /** The identifier at a position; empty if there is none. */
  String word(int from) {
    int at = from;
    while (at < text.length() && isWordPart(text.charAt(at))) {
      at++;
    }
    return at == from || Character.isDigit(text.charAt(from)) ? "" : text.substring(from, at);
  }

  /** Whether the end, a closing parenthesis or an operator of the logic is at a position. */
  boolean endsAtom(int at) {
    return at >= text.length()
        || ")]}".indexOf(text.charAt(at)) >= 0
        || text.startsWith("&&", at)
        || text.startsWith("||", at)
        || text.startsWith("->", at);
  }

  /** The position after the character, word, number, string or comment at a position. */
  int next(int at) {
    char c = text.charAt(at);
    if (c == '"' || c == '\'') {
      return afterString(at);
    }
    if (isWordPart(c)) {
      int end = at;
      while (end < text.length() && isWordPart(text.charAt(end))) {
        end++;
      }
      return end;
    }
    return Math.max(at + 1, skipSpace(at));
  }

  /** The position of the parenthesis that closes the one at a position; -1 if there is none. */
  int closing(int opening) {
    int depth = 0;
    for (int at = opening; at < text.length(); at = next(at)) {
      char c = text.charAt(at);
      if (c == '(' || c == '[' || c == '{') {
        depth++;
      } else if ((c == ')' || c == ']' || c == '}') && --depth == 0) {
        return at;
      }
    }
    return -1;
  }

  /** Whether {@code ?} occurs between two positions, outside of inner parentheses. */
  boolean hasConditional(int begin, int end) {
    return outside(begin, end, '?') >= 0;
  }

  /** The only comma between two positions, outside of inner parentheses; -1 if not exactly one. */
  int comma(int begin, int end) {
    int found = outside(begin, end, ',');
    return found < 0 || outside(found + 1, end, ',') >= 0 ? -1 : found;
  }

  private int outside(int begin, int end, char wanted) {
    int depth = 0;
    for (int at = begin; at < end; at = next(at)) {
      char c = text.charAt(at);
      if (c == wanted && depth == 0) {
        return at;
      } else if (c == '(' || c == '[' || c == '{') {
        depth++;
      } else if (c == ')' || c == ']' || c == '}') {
        depth--;
      }
    }
    return -1;
  }

  /** The position of a temporal operator between two positions; -1 if there is none. */
  int temporalOperator(int begin, int end) {
    for (int at = begin; at < end; at = next(at)) {
      String word = word(at);
      boolean operator =
          switch (word) {
            case "always", "eventually", "once", "historically" ->
                text.startsWith("(", skipSpace(at + word.length()));
            default -> false;
          };
      if (operator && (at == 0 || text.charAt(at - 1) != '.')) {
        return at;
      }
    }
    return -1;
  }

  /** The line of a position, from 1. */
  int line(int position) {
    return 1
        + (int)
            text.chars().limit(Math.min(position, text.length())).filter(c -> c == '\n').count();
  }

  /** The column of a position, from 1. */
  int column(int position) {
    int at = Math.min(position, text.length());
    return at - text.lastIndexOf('\n', at - 1);
  }

  private int afterString(int begin) {
    char quote = text.charAt(begin);
    boolean raw = begin > 0 && (text.charAt(begin - 1) == 'r' || text.charAt(begin - 1) == 'R');
    String triple = String.valueOf(quote).repeat(3);
    boolean isTriple = text.startsWith(triple, begin);
    int at = begin + (isTriple ? 3 : 1);
    while (at < text.length()) {
      if (!raw && text.charAt(at) == '\\') {
        at += 2;
      } else if (isTriple ? text.startsWith(triple, at) : text.charAt(at) == quote) {
        return at + (isTriple ? 3 : 1);
      } else {
        at++;
      }
    }
    return text.length();
  }

  private static boolean isWordPart(char c) {
    return c == '_' || c < 128 && Character.isLetterOrDigit(c);
  }
}
