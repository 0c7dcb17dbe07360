package org.sitaf.core.trajectory;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.regex.Pattern;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.expression.type.TypeCheck;
import org.sitaf.core.trajectory.Formula.Quantifier;
import org.sitaf.core.trajectory.ParsedFormula.AtomText;
import org.sitaf.core.trajectory.ParsedFormula.IntervalText;

/**
 * Parses formulas by recursive descent. The logic has, from tight to loose, {@code !}, {@code
 * until} and {@code since}, {@code &&}, {@code ||}, {@code ->}; the text between its operators is
 * an atom in CEL, which is not parsed here.
 */
final class FormulaParser {
  private static final int MAX_CHARACTERS = 20_000;
  private static final int MAX_NESTING = 100;
  private static final int MAX_OPERATORS = 500;
  private static final Set<String> BINARY = Set.of("until", "since");

  /** What follows an operator: its interval, and a parenthesis. */
  private static final Pattern OPERAND = Pattern.compile("(\\[[^\\]]*\\]\\s*)?\\(");

  private static final Set<String> UNARY = Set.of("always", "eventually", "once", "historically");

  private final String text;
  private final FormulaText scanner;
  private final ToDoubleFunction<String> bound;
  private final List<AtomText> atoms = new ArrayList<>();
  private final List<IntervalText> intervals = new ArrayList<>();
  private int at;
  private int nesting;
  private int operators;

  private FormulaParser(String text, ToDoubleFunction<String> bound) {
    this.text = text;
    this.scanner = new FormulaText(text);
    this.bound = bound;
  }

  /**
   * Parses a formula.
   *
   * @param bound evaluates a constant expression, a bound of an interval in seconds; throws {@link
   *     IllegalArgumentException} if it is not a number
   * @throws FormulaException if the text is not a formula
   */
  static ParsedFormula parse(String text, ToDoubleFunction<String> bound) throws FormulaException {
    FormulaParser parser = new FormulaParser(text, bound);
    if (text.length() > MAX_CHARACTERS) {
      throw parser.error(0, "has more than " + MAX_CHARACTERS + " characters; simplify it");
    }
    Formula formula = parser.implication();
    if (parser.at < text.length()) {
      throw parser.error(parser.at, "unexpected '" + text.charAt(parser.at) + "'");
    }
    return new ParsedFormula(formula, parser.atoms, parser.intervals);
  }

  private Formula implication() throws FormulaException {
    Formula left = disjunction();
    if (!accept("->")) {
      return left;
    }
    enter();
    Formula right = implication();
    nesting--;
    return new Formula.Implies(left, right);
  }

  private Formula disjunction() throws FormulaException {
    Formula left = conjunction();
    while (accept("||")) {
      left = new Formula.Or(left, conjunction());
    }
    return left;
  }

  private Formula conjunction() throws FormulaException {
    Formula left = binary();
    while (accept("&&")) {
      left = new Formula.And(left, binary());
    }
    return left;
  }

  private Formula binary() throws FormulaException {
    Formula left = unary();
    String operator = scanner.word(skipSpace());
    if (!BINARY.contains(operator)) {
      return left;
    }
    count();
    at += operator.length();
    Interval interval = interval();
    Formula right = unary();
    String next = scanner.word(skipSpace());
    if (BINARY.contains(next)) {
      throw error(at, "until and since cannot be chained; put one of them in parentheses");
    }
    return operator.equals("until")
        ? new Formula.Until(interval, left, right)
        : new Formula.Since(interval, left, right);
  }

  private Formula unary() throws FormulaException {
    enter();
    Formula formula = operand();
    nesting--;
    return formula;
  }

  private Formula operand() throws FormulaException {
    skipSpace();
    if (text.startsWith("!", at)) {
      at++;
      count();
      return new Formula.Not(unary());
    }
    String word = scanner.word(at);
    int after = scanner.skipSpace(at + word.length());
    if (UNARY.contains(word) && (text.startsWith("(", after) || text.startsWith("[", after))) {
      at += word.length();
      count();
      Interval interval = interval();
      if (!text.startsWith("(", skipSpace())) {
        throw error(at, "the operand of " + word + " must be in parentheses");
      }
      return new Formula.Window(
          Quantifier.valueOf(word.toUpperCase(Locale.ROOT)), interval, parenthesized());
    }
    if (!word.isEmpty() && OPERAND.matcher(text).region(after, text.length()).lookingAt()) {
      requireFunction(word);
    }
    return isGroup() ? parenthesized() : atom();
  }

  /** Rejects a name that is a misspelt operator rather than a function. */
  private void requireFunction(String word) throws FormulaException {
    List<String> known = new ArrayList<>(TypeCheck.functions());
    known.addAll(UNARY);
    Optional<String> nearest = NearestName.of(word, known).filter(UNARY::contains);
    if (nearest.isPresent()) {
      throw error(at, "unknown operator '" + word + "'; did you mean '" + nearest.get() + "'?");
    }
  }

  private Formula parenthesized() throws FormulaException {
    int opening = at++;
    Formula formula = implication();
    if (!text.startsWith(")", skipSpace())) {
      throw at < text.length()
          ? error(at, "unexpected '" + text.charAt(at) + "'")
          : error(opening, "this parenthesis is not closed");
    }
    at++;
    return formula;
  }

  /**
   * Whether a parenthesis begins here that belongs to the logic: an operator of the logic or the
   * end follows it, and it does not enclose {@code ?:}.
   */
  private boolean isGroup() throws FormulaException {
    if (!text.startsWith("(", at)) {
      return false;
    }
    int closing = closing(at);
    int next = scanner.skipSpace(closing + 1);
    return (scanner.endsAtom(next) || BINARY.contains(scanner.word(next)))
        && !scanner.hasConditional(at + 1, closing);
  }

  private int closing(int opening) throws FormulaException {
    int closing = scanner.closing(opening);
    if (closing < 0) {
      throw error(opening, "this parenthesis is not closed");
    }
    return closing;
  }

  private Formula atom() throws FormulaException {
    int begin = at;
    while (!scanner.endsAtom(at)) {
      char c = text.charAt(at);
      String word = scanner.word(at);
      if (at > begin && BINARY.contains(word) && text.charAt(at - 1) != '.') {
        break;
      } else if (UNARY.contains(word)
          && text.startsWith("(", scanner.skipSpace(at + word.length()))) {
        throw error(at, "an operator is missing before " + word);
      } else if (c == '?') {
        throw error(at, "put the whole expression with ?: in parentheses");
      } else if (c == '(' || c == '[' || c == '{') {
        int closing = closing(at);
        int operator = scanner.temporalOperator(at, closing);
        if (operator >= 0) {
          throw error(
              operator,
              scanner.word(operator)
                  + " cannot be part of a comparison, a function or ?:; use && || -> ! between"
                  + " temporal operators");
        }
        at = closing + 1;
      } else {
        at = scanner.next(at);
      }
    }
    String atom = text.substring(begin, at).strip();
    if (atom.isEmpty()) {
      throw error(
          begin,
          begin < text.length()
              ? "a condition is missing before '" + text.charAt(begin) + "'"
              : "a condition is missing at the end");
    }
    checkBeginsWithOperand(begin);
    count();
    atoms.add(new AtomText(atom, scanner.line(begin), scanner.column(begin)));
    return new Formula.Atom(atoms.size() - 1);
  }

  private void checkBeginsWithOperand(int begin) throws FormulaException {
    String word = scanner.word(begin);
    int next = scanner.skipSpace(begin + word.length());
    boolean isOperator = next == at || !scanner.word(next).isEmpty() || text.startsWith("(", next);
    if (BINARY.contains(word) && isOperator) {
      throw error(begin, "a condition is missing before " + word);
    } else if (UNARY.contains(word) && isOperator && next < at) {
      throw error(begin, "the operand of " + word + " must be in parentheses");
    }
  }

  private Interval interval() throws FormulaException {
    int opening = skipSpace();
    if (!text.startsWith("[", opening)) {
      return Interval.UNBOUNDED;
    }
    int closing = closing(opening);
    int comma = scanner.comma(opening + 1, closing);
    if (comma < 0) {
      throw error(opening, "an interval must be [from, to] in seconds");
    }
    double from = bound(opening + 1, comma);
    double to = bound(comma + 1, closing);
    if (!(from >= 0) || Double.isInfinite(from)) {
      throw error(opening, "an interval must begin at a finite number of 0 or more seconds");
    }
    if (!(to >= from)) {
      throw error(opening, "the interval ends before it begins");
    }
    at = closing + 1;
    Interval interval = new Interval(from, to);
    intervals.add(new IntervalText(interval, scanner.line(opening), scanner.column(opening)));
    return interval;
  }

  private double bound(int begin, int end) throws FormulaException {
    String constant = text.substring(begin, end).strip();
    try {
      if (constant.isEmpty()) {
        throw new IllegalArgumentException("is missing");
      }
      return bound.applyAsDouble(constant);
    } catch (IllegalArgumentException e) {
      throw error(
          scanner.skipSpace(begin),
          "a bound of an interval must be a constant number of seconds: " + e.getMessage());
    }
  }

  private boolean accept(String operator) throws FormulaException {
    if (!text.startsWith(operator, skipSpace())) {
      return false;
    }
    count();
    at += operator.length();
    return true;
  }

  private int skipSpace() {
    at = scanner.skipSpace(at);
    return at;
  }

  private void enter() throws FormulaException {
    if (++nesting > MAX_NESTING) {
      throw error(at, "is nested deeper than " + MAX_NESTING + " levels; simplify it");
    }
  }

  private void count() throws FormulaException {
    if (++operators > MAX_OPERATORS) {
      throw error(at, "has more than " + MAX_OPERATORS + " operators and atoms; simplify it");
    }
  }

  private FormulaException error(int position, String message) {
    return new FormulaException(message, scanner.line(position), scanner.column(position));
  }
}
