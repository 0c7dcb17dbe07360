package org.sitaf.core.score.mutation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sitaf.core.score.mutation.SourceTokens.Kind;
import org.sitaf.core.score.mutation.SourceTokens.Token;

/**
 * The mutations of a source: those that PIT and Mull make without configuration. Boundaries and
 * negations of comparisons, arithmetic, increments, negative numbers, logical operators, returned
 * values, and calls left out whose result is not used.
 *
 * <p>Source: H. Coles et al., PIT, a practical mutation testing tool for Java, ISSTA 2016; A.
 * Denisov and S. Pankevich, Mull it over, ICSTW 2018.
 */
public final class Mutations {
  private static final Map<String, List<String>> OPERATORS =
      Map.ofEntries(
          Map.entry("<", List.of("<=", ">=")),
          Map.entry("<=", List.of("<", ">")),
          Map.entry(">", List.of(">=", "<=")),
          Map.entry(">=", List.of(">", "<")),
          Map.entry("==", List.of("!=")),
          Map.entry("!=", List.of("==")),
          Map.entry("&&", List.of("||")),
          Map.entry("||", List.of("&&")),
          Map.entry("*", List.of("/")),
          Map.entry("/", List.of("*")),
          Map.entry("%", List.of("*")),
          Map.entry("//", List.of("*")),
          Map.entry("**", List.of("*")),
          Map.entry("++", List.of("--")),
          Map.entry("--", List.of("++")),
          Map.entry("+=", List.of("-=")),
          Map.entry("-=", List.of("+=")),
          Map.entry("*=", List.of("/=")),
          Map.entry("/=", List.of("*=")));

  /** In Python. */
  private static final Map<String, String> WORDS =
      Map.of("and", "or", "or", "and", "True", "False", "False", "True");

  private static final Map<String, String> LITERALS = Map.of("true", "false", "false", "true");

  /** After these words, a minus is the sign of a number. */
  private static final Set<String> BEFORE_A_SIGN =
      Set.of("return", "and", "or", "not", "in", "if", "else", "elif", "while", "yield", "case");

  /** A statement that begins with one of these words is no call. */
  private static final Set<String> NO_CALLS =
      Set.of(
          "if",
          "for",
          "while",
          "switch",
          "catch",
          "super",
          "this",
          "return",
          "throw",
          "new",
          "synchronized",
          "assert",
          "def",
          "class",
          "with",
          "print",
          "raise",
          "del",
          "yield");

  private final String path;
  private final String source;
  private final boolean python;
  private final List<Token> tokens;
  private final List<Mutation> found = new ArrayList<>();

  /** The number of open brackets before each token. */
  private final int[] depths;

  private Mutations(String path, String source, boolean python) {
    this.path = path;
    this.source = source;
    this.python = python;
    this.tokens = SourceTokens.of(source, python);
    this.depths = new int[tokens.size() + 1];
    for (int i = 0; i < tokens.size(); i++) {
      depths[i + 1] = depths[i] + depthOf(tokens.get(i));
    }
  }

  /**
   * All mutations of a file, in the order of their places. A compiler may reject some of them.
   *
   * @param python whether the source is Python; otherwise C++ or Java
   */
  public static List<Mutation> of(String path, String source, boolean python) {
    Mutations mutations = new Mutations(path, source, python);
    mutations.collect();
    return List.copyOf(mutations.found);
  }

  private void collect() {
    for (int i = 0; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      if (token.kind() == Kind.OPERATOR) {
        operator(i, token);
      } else if (token.kind() == Kind.WORD) {
        word(i, token);
      }
    }
  }

  private void operator(int i, Token token) {
    if (token.is("+") || token.is("-")) {
      if (endsAnOperand(i - 1)) {
        replace(token, token.is("+") ? "-" : "+");
      } else if (token.is("-")) {
        change(token.start(), token.end(), token.line(), "", "sign - left out");
      }
      return;
    }
    // Arguments of templates and generics have no spaces around their brackets.
    boolean bracket = (token.is("<") || token.is(">")) && !isSpaced(token);
    if (!bracket) {
      OPERATORS.getOrDefault(token.text(), List.of()).forEach(other -> replace(token, other));
    }
  }

  private boolean isSpaced(Token token) {
    return token.start() > 0
        && Character.isWhitespace(source.charAt(token.start() - 1))
        && token.end() < source.length()
        && Character.isWhitespace(source.charAt(token.end()));
  }

  /** Whether a minus after this token subtracts. */
  private boolean endsAnOperand(int i) {
    if (i < 0) {
      return false;
    }
    Token token = tokens.get(i);
    return switch (token.kind()) {
      case NUMBER, TEXT -> true;
      case WORD -> !BEFORE_A_SIGN.contains(token.text());
      case OPERATOR -> token.is(")") || token.is("]");
    };
  }

  private void word(int i, Token token) {
    String other = (python ? WORDS : LITERALS).get(token.text());
    if (other != null) {
      replace(token, other);
    } else if (python && token.is("not") && !(i > 0 && tokens.get(i - 1).is("is"))) {
      boolean within = i + 1 < tokens.size() && tokens.get(i + 1).is("in");
      change(
          token.start(),
          token.end(),
          token.line(),
          "",
          within ? "not in replaced by in" : "not left out");
    } else if (token.is("return")) {
      returned(i);
    } else if (beginsStatement(i) && !NO_CALLS.contains(token.text())) {
      call(i);
    }
  }

  private void returned(int i) {
    int end = endOfStatement(i + 1);
    if (end <= i + 1) {
      return;
    }
    List<Token> value = tokens.subList(i + 1, end);
    int from = value.get(0).start();
    int to = value.get(value.size() - 1).end();
    boolean logical = value.stream().anyMatch(Mutations::isLogical);
    if (value.size() == 1 && value.get(0).kind() == Kind.NUMBER) {
      boolean zero = value.get(0).text().matches("[0.]+[fFdDL]?");
      returns(i, from, to, zero ? "1" : "0");
    } else if (value.size() == 1 && value.get(0).kind() == Kind.TEXT) {
      returns(i, from, to, "\"\"");
    } else if (logical) {
      returns(i, from, to, (python ? "not (" : "!(") + source.substring(from, to) + ")");
    } else if (!(value.size() == 1 && isLiteral(value.get(0)))) {
      returns(i, from, to, python ? "None" : "0");
    }
  }

  private static boolean isLogical(Token token) {
    return switch (token.text()) {
      case "==", "!=", "<=", ">=", "&&", "||", "!", "and", "or", "not", "in" -> true;
      default -> false;
    };
  }

  private static boolean isLiteral(Token token) {
    return switch (token.text()) {
      case "true", "false", "null", "nullptr", "True", "False", "None" -> true;
      default -> false;
    };
  }

  private void returns(int i, int from, int to, String value) {
    String shown = value.contains("(") ? "the opposite" : value;
    change(from, to, tokens.get(i).line(), value, "returns " + shown);
  }

  /** A call whose result is not used. */
  private void call(int i) {
    int next = i + 1;
    while (next + 1 < tokens.size()
        && (tokens.get(next).is(".") || tokens.get(next).is("->") || tokens.get(next).is("::"))
        && tokens.get(next + 1).kind() == Kind.WORD) {
      next += 2;
    }
    if (next >= tokens.size() || !tokens.get(next).is("(")) {
      return;
    }
    int end = endOfStatement(i);
    if (end <= next || !tokens.get(end - 1).is(")") || closing(next) != end - 1) {
      return;
    }
    String name = source.substring(tokens.get(i).start(), tokens.get(next - 1).end());
    change(
        tokens.get(i).start(),
        tokens.get(end - 1).end(),
        tokens.get(i).line(),
        python ? "pass" : "",
        "call of " + name.replaceAll("\\s+", "") + " left out");
  }

  private int closing(int open) {
    int depth = 0;
    for (int i = open; i < tokens.size(); i++) {
      depth += depthOf(tokens.get(i));
      if (depth == 0) {
        return i;
      }
    }
    return -1;
  }

  private static int depthOf(Token token) {
    return switch (token.text()) {
      case "(", "[", "{" -> 1;
      case ")", "]", "}" -> -1;
      default -> 0;
    };
  }

  private boolean beginsStatement(int i) {
    if (python) {
      int lineStart = source.lastIndexOf('\n', tokens.get(i).start()) + 1;
      return source.substring(lineStart, tokens.get(i).start()).isBlank() && depths[i] == 0;
    }
    return i > 0
        && (tokens.get(i - 1).is(";") || tokens.get(i - 1).is("{") || tokens.get(i - 1).is("}"));
  }

  /** The token after the last one of a statement: a semicolon, or in Python one of another line. */
  private int endOfStatement(int begin) {
    int depth = 0;
    for (int i = begin; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      boolean ends = python ? i > begin && isNextLine(tokens.get(i - 1), token) : token.is(";");
      if (depth == 0 && ends) {
        return i;
      }
      depth += depthOf(token);
      if (depth < 0) {
        return begin;
      }
    }
    return python ? tokens.size() : begin;
  }

  private boolean isNextLine(Token before, Token token) {
    return source.substring(before.end(), token.start()).contains("\n");
  }

  private void replace(Token token, String other) {
    change(token.start(), token.end(), token.line(), other, token.text() + " replaced by " + other);
  }

  private void change(int start, int end, int line, String replacement, String text) {
    found.add(new Mutation(path, line, text, start, end, replacement));
  }
}
