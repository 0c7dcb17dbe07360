package org.sitaf.core.description.idl.preprocessor;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.sitaf.core.description.idl.preprocessor.Lexeme.Kind;
import org.sitaf.core.description.idl.preprocessor.MacroExpansion.MacroException;

/** Evaluates the expression of {@code #if} with 64-bit integers. */
final class Condition {
  /** Maximum nesting of brackets and unary operators; the evaluation recurses once per level. */
  private static final int MAX_DEPTH = 100;

  private static final int UNARY = 11;

  private static final Map<String, Integer> PRECEDENCE =
      Map.ofEntries(
          Map.entry("||", 1),
          Map.entry("&&", 2),
          Map.entry("|", 3),
          Map.entry("^", 4),
          Map.entry("&", 5),
          Map.entry("==", 6),
          Map.entry("!=", 6),
          Map.entry("<", 7),
          Map.entry(">", 7),
          Map.entry("<=", 7),
          Map.entry(">=", 7),
          Map.entry("<<", 8),
          Map.entry(">>", 8),
          Map.entry("+", 9),
          Map.entry("-", 9),
          Map.entry("*", 10),
          Map.entry("/", 10),
          Map.entry("%", 10));

  /** The expression cannot be read or has no value. */
  static final class ConditionException extends Exception {
    private static final long serialVersionUID = 1L;

    ConditionException(String message) {
      super(message);
    }
  }

  private final List<Lexeme> lexemes;
  private int at;
  private int depth;

  private Condition(List<Lexeme> lexemes) {
    this.lexemes = lexemes.stream().filter(lexeme -> !lexeme.isSpace()).toList();
  }

  /**
   * Evaluates an expression.
   *
   * @param defined whether a macro is defined
   */
  static boolean isTrue(List<Lexeme> line, Predicate<String> defined, MacroExpansion expansion)
      throws ConditionException, MacroException {
    Condition condition = new Condition(expansion.expand(withDefined(line, defined)));
    if (condition.lexemes.isEmpty()) {
      throw new ConditionException("the expression is missing");
    }
    long value = condition.conditional(true);
    if (condition.at < condition.lexemes.size()) {
      throw new ConditionException("'" + condition.peek() + "' does not belong there");
    }
    return value != 0;
  }

  /** Replaces {@code defined NAME} and {@code defined(NAME)} before macros are replaced. */
  private static List<Lexeme> withDefined(List<Lexeme> line, Predicate<String> defined)
      throws ConditionException {
    List<Lexeme> plain = line.stream().filter(lexeme -> !lexeme.isSpace()).toList();
    List<Lexeme> output = new ArrayList<>();
    for (int i = 0; i < plain.size(); i++) {
      if (!plain.get(i).is("defined")) {
        output.add(plain.get(i));
        continue;
      }
      boolean bracket = i + 1 < plain.size() && plain.get(i + 1).is("(");
      int name = i + (bracket ? 2 : 1);
      int last = bracket ? name + 1 : name;
      if (last >= plain.size()
          || !plain.get(name).isName()
          || bracket && !plain.get(last).is(")")) {
        throw new ConditionException("'defined' needs a name: write defined(NAME)");
      }
      output.add(new Lexeme(Kind.NUMBER, defined.test(plain.get(name).text()) ? "1" : "0"));
      i = last;
    }
    return output;
  }

  /**
   * @param counts false in a part whose value is not needed, such as the right side of {@code 0 &&}
   */
  private long conditional(boolean counts) throws ConditionException {
    long condition = binary(1, counts);
    if (!accept("?")) {
      return condition;
    }
    enter();
    long first = conditional(counts && condition != 0);
    expect(":");
    long second = conditional(counts && condition == 0);
    depth--;
    return condition != 0 ? first : second;
  }

  private long binary(int precedence, boolean counts) throws ConditionException {
    if (precedence == UNARY) {
      return unary(counts);
    }
    long left = binary(precedence + 1, counts);
    while (PRECEDENCE.getOrDefault(peek(), 0) == precedence) {
      String operator = take();
      boolean skipped = operator.equals("&&") && left == 0 || operator.equals("||") && left != 0;
      long right = binary(precedence + 1, counts && !skipped);
      left = apply(operator, left, right, counts);
    }
    return left;
  }

  private static long apply(String operator, long left, long right, boolean counts)
      throws ConditionException {
    return switch (operator) {
      case "||" -> truth(left != 0 || right != 0);
      case "&&" -> truth(left != 0 && right != 0);
      case "|" -> left | right;
      case "^" -> left ^ right;
      case "&" -> left & right;
      case "==" -> truth(left == right);
      case "!=" -> truth(left != right);
      case "<" -> truth(left < right);
      case ">" -> truth(left > right);
      case "<=" -> truth(left <= right);
      case ">=" -> truth(left >= right);
      case "<<" -> left << right;
      case ">>" -> left >> right;
      case "+" -> left + right;
      case "-" -> left - right;
      case "*" -> left * right;
      default -> divided(operator, left, right, counts);
    };
  }

  private static long divided(String operator, long left, long right, boolean counts)
      throws ConditionException {
    if (right == 0) {
      if (counts) {
        throw new ConditionException("division by zero");
      }
      return 0;
    }
    return operator.equals("/") ? left / right : left % right;
  }

  private long unary(boolean counts) throws ConditionException {
    enter();
    try {
      if (accept("!")) {
        return truth(unary(counts) == 0);
      }
      if (accept("-")) {
        return -unary(counts);
      }
      if (accept("+")) {
        return unary(counts);
      }
      if (accept("~")) {
        return ~unary(counts);
      }
      if (accept("(")) {
        long value = conditional(counts);
        expect(")");
        return value;
      }
      return primary();
    } finally {
      depth--;
    }
  }

  private long primary() throws ConditionException {
    if (at >= lexemes.size()) {
      throw new ConditionException("the expression ends too early");
    }
    Lexeme lexeme = lexemes.get(at);
    at++;
    return switch (lexeme.kind()) {
      // A name that is no macro is 0 in C; true is the exception of C++.
      case NAME -> truth(lexeme.is("true"));
      case NUMBER -> number(lexeme.text());
      case LITERAL -> character(lexeme.text());
      default -> throw new ConditionException("'" + lexeme.text() + "' does not belong there");
    };
  }

  private static long number(String text) throws ConditionException {
    String digits = text.replaceFirst("[uUlL]{1,3}$", "").replace("'", "");
    try {
      return Long.decode(digits);
    } catch (NumberFormatException e) {
      throw new ConditionException("'" + text + "' is not a whole number of 64 bits");
    }
  }

  private static long character(String text) throws ConditionException {
    if (text.length() == 3 && text.charAt(0) == '\'') {
      return text.charAt(1);
    }
    throw new ConditionException(text + " is not a number");
  }

  private void enter() throws ConditionException {
    depth++;
    if (depth > MAX_DEPTH) {
      throw new ConditionException("the expression nests deeper than " + MAX_DEPTH + " levels");
    }
  }

  private String peek() {
    return at < lexemes.size() ? lexemes.get(at).text() : "";
  }

  private String take() {
    String text = peek();
    at++;
    return text;
  }

  private boolean accept(String text) {
    boolean is = peek().equals(text);
    at += is ? 1 : 0;
    return is;
  }

  private void expect(String text) throws ConditionException {
    if (!accept(text)) {
      throw new ConditionException("'" + text + "' is missing");
    }
  }

  private static long truth(boolean value) {
    return value ? 1 : 0;
  }
}
