package org.sitaf.core.score.mutation;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The tokens of a source file in C++, Java or Python, without comments, preprocessor lines and
 * annotations. That is enough to find operators: a change that the compiler rejects is no mutation.
 */
final class SourceTokens {
  /** In the order of preference; each alternative is linear in the length of the text. */
  private static final String CODE =
      "(?<word>[\\p{L}_$][\\p{L}\\p{N}_$]*)|(?<number>\\.?\\d[\\w.]*+(?:(?<=[eE])[+-]\\d+)?)"
          + "|(?<operator><<=|>>=|\\*\\*|//|->|::|\\+\\+|--|<=|>=|==|!=|&&|\\|\\||[-+*/%&|^]=|<<|>>"
          + "|[^\\s\\w])";

  private static final String QUOTED = "\"(?:[^\"\\\\\\n]|\\\\.)*+\"?|'(?:[^'\\\\\\n]|\\\\.)*+'?";

  private static final Pattern BRACES =
      Pattern.compile(
          "(?<skipped>//[^\\n]*|/\\*(?:[^*]|\\*(?!/))*+(?:\\*/)?|(?m:^[ \\t]*#(?:\\\\\\r?\\n|[^\\n])*+)"
              + "|@[\\p{L}_][\\w.]*)|(?<text>R\"\\((?:[^)]|\\)(?!\"))*+\\)\"|\"\"\"(?:[^\"]|\"(?!\"\"))*+\"\"\"|"
              + QUOTED
              + ")|"
              + CODE,
          Pattern.DOTALL);

  private static final Pattern PYTHON =
      Pattern.compile(
          "(?<skipped>#[^\\n]*|(?m:^[ \\t]*@[^\\n]*))"
              + "|(?<text>[rRbBfFuU]{0,2}(?:\"\"\"(?:[^\"\\\\]|\\\\.|\"(?!\"\"))*+\"\"\""
              + "|'''(?:[^'\\\\]|\\\\.|'(?!''))*+'''|"
              + QUOTED
              + "))|"
              + CODE,
          Pattern.DOTALL);

  /** What a token is. */
  enum Kind {
    WORD,
    NUMBER,
    TEXT,
    OPERATOR
  }

  /** A token at its place in the source. */
  record Token(Kind kind, String text, int start, int end, int line) {
    boolean is(String other) {
      return text.equals(other);
    }
  }

  private SourceTokens() {}

  static List<Token> of(String source, boolean python) {
    List<Token> tokens = new ArrayList<>();
    Matcher found = (python ? PYTHON : BRACES).matcher(source);
    int line = 1;
    int counted = 0;
    while (found.find()) {
      for (; counted < found.start(); counted++) {
        if (source.charAt(counted) == '\n') {
          line++;
        }
      }
      if (found.group("skipped") == null) {
        tokens.add(new Token(kindOf(found), found.group(), found.start(), found.end(), line));
      }
    }
    return tokens;
  }

  private static Kind kindOf(Matcher found) {
    if (found.group("text") != null) {
      return Kind.TEXT;
    }
    if (found.group("word") != null) {
      return Kind.WORD;
    }
    return found.group("number") != null ? Kind.NUMBER : Kind.OPERATOR;
  }
}
