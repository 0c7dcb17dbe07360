package org.sitaf.core.description.idl.preprocessor;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A preprocessing token.
 *
 * @param text its characters; a single blank for white space
 * @param hidden names of the macros that must not replace it again
 */
record Lexeme(Kind kind, String text, Set<String> hidden) {
  enum Kind {
    NAME,
    NUMBER,
    /** String or character literal. */
    LITERAL,
    PUNCTUATION,
    SPACE
  }

  static final Lexeme BLANK = new Lexeme(Kind.SPACE, " ", Set.of());

  private static final List<String> LONG_PUNCTUATION =
      List.of("##", "&&", "||", "==", "!=", "<=", ">=", "<<", ">>", "::");

  Lexeme(Kind kind, String text) {
    this(kind, text, Set.of());
  }

  boolean is(String other) {
    return text.equals(other);
  }

  boolean isName() {
    return kind == Kind.NAME;
  }

  boolean isSpace() {
    return kind == Kind.SPACE;
  }

  /** Splits a line without comments and line breaks. Any text can be split. */
  static List<Lexeme> split(String line) {
    List<Lexeme> lexemes = new ArrayList<>();
    int at = 0;
    while (at < line.length()) {
      int end = end(line, at);
      char first = line.charAt(at);
      if (Character.isWhitespace(first)) {
        lexemes.add(BLANK);
      } else {
        lexemes.add(new Lexeme(kind(line, at), line.substring(at, end)));
      }
      at = end;
    }
    return lexemes;
  }

  /** Splits a line and removes white space at both ends. */
  static List<Lexeme> splitTrimmed(String line) {
    return split(line.strip());
  }

  static String text(List<Lexeme> lexemes) {
    StringBuilder text = new StringBuilder();
    lexemes.forEach(lexeme -> text.append(lexeme.text()));
    return text.toString();
  }

  private static Kind kind(String line, int at) {
    char first = line.charAt(at);
    if (isNameStart(first)) {
      return Kind.NAME;
    }
    if (isNumberStart(line, at)) {
      return Kind.NUMBER;
    }
    return first == '"' || first == '\'' ? Kind.LITERAL : Kind.PUNCTUATION;
  }

  private static int end(String line, int at) {
    char first = line.charAt(at);
    int end = at + 1;
    if (Character.isWhitespace(first)) {
      while (end < line.length() && Character.isWhitespace(line.charAt(end))) {
        end++;
      }
    } else if (isNameStart(first)) {
      while (end < line.length() && isNamePart(line.charAt(end))) {
        end++;
      }
    } else if (isNumberStart(line, at)) {
      while (end < line.length() && isNumberPart(line, end)) {
        end++;
      }
    } else if (first == '"' || first == '\'') {
      end = literalEnd(line, at);
    } else {
      for (String operator : LONG_PUNCTUATION) {
        if (line.startsWith(operator, at)) {
          return at + 2;
        }
      }
    }
    return end;
  }

  /** The end of a literal, or of the line if its closing quote is missing. */
  static int literalEnd(String line, int at) {
    char quote = line.charAt(at);
    for (int i = at + 1; i < line.length(); i++) {
      if (line.charAt(i) == '\\') {
        i++;
      } else if (line.charAt(i) == quote) {
        return i + 1;
      }
    }
    return line.length();
  }

  private static boolean isNameStart(char c) {
    return c == '_' || Character.isLetter(c);
  }

  private static boolean isNamePart(char c) {
    return c == '_' || Character.isLetterOrDigit(c);
  }

  private static boolean isNumberStart(String line, int at) {
    char first = line.charAt(at);
    return isDigit(first) || first == '.' && at + 1 < line.length() && isDigit(line.charAt(at + 1));
  }

  private static boolean isNumberPart(String line, int at) {
    char c = line.charAt(at);
    boolean signOfExponent =
        (c == '+' || c == '-')
            && "eE".indexOf(line.charAt(at - 1)) >= 0
            && !isHexadecimal(line, at);
    return isNamePart(c) || c == '.' || signOfExponent;
  }

  private static boolean isHexadecimal(String line, int at) {
    int start = at;
    while (start > 0 && (isNamePart(line.charAt(start - 1)) || line.charAt(start - 1) == '.')) {
      start--;
    }
    return line.startsWith("0x", start) || line.startsWith("0X", start);
  }

  private static boolean isDigit(char c) {
    return c >= '0' && c <= '9';
  }
}
