package org.sitaf.core.description.idl;

import java.math.BigInteger;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ExpressionContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.PrimaryContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.UnaryContext;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;

/** Evaluates integer constants and bounds. */
final class IdlConstants {
  private static final int MAX_BITS = 128;
  private static final int MAX_CHAIN = 40;

  private static final Pattern REAL =
      Pattern.compile("[-+]?(\\d{1,300}\\.?\\d{0,300}|\\.\\d{1,300})([eE][-+]?\\d{1,4})?[dDfF]?");

  private final IdlScopes scopes;
  private final Findings findings;
  private final Map<String, Constant> constants = new HashMap<>();
  private int chain;

  IdlConstants(IdlScopes scopes, Findings findings) {
    this.scopes = scopes;
    this.findings = findings;
  }

  /**
   * Declares a constant.
   *
   * @return false if the name is already declared
   */
  boolean declare(String qualified, String scope, ExpressionContext expression) {
    return constants.putIfAbsent(qualified, new Constant(scope, expression)) == null;
  }

  /** The length of an array. An invalid length is reported. */
  OptionalInt length(ExpressionContext expression, String scope, Place place) {
    Optional<BigInteger> value = positive(expression, scope, place);
    if (value.isPresent() && value.get().bitLength() >= Integer.SIZE) {
      findings.error(
          place, "an array has at most " + Integer.MAX_VALUE + " elements, not " + value.get());
      return OptionalInt.empty();
    }
    return value.map(v -> OptionalInt.of(v.intValueExact())).orElse(OptionalInt.empty());
  }

  /**
   * The bound of a sequence or a string; 0 for one beyond the length of any sequence or string. An
   * invalid bound is reported.
   */
  int bound(ExpressionContext expression, String scope, Place place) {
    return positive(expression, scope, place)
        .filter(value -> value.bitLength() < Integer.SIZE)
        .map(BigInteger::intValueExact)
        .orElse(0);
  }

  private Optional<BigInteger> positive(ExpressionContext expression, String scope, Place place) {
    try {
      BigInteger value = value(expression, scope);
      if (value.signum() > 0) {
        return Optional.of(value);
      }
      findings.error(place, "a length or bound must be at least 1, not " + value);
    } catch (NoNumberException e) {
      findings.error(place, String.valueOf(e.getMessage()));
    }
    return Optional.empty();
  }

  /**
   * The constants by their names with dots. Those of other types and beyond 64 bits are left out.
   */
  Map<String, Object> values() {
    Map<String, Object> values = new TreeMap<>();
    constants.forEach(
        (name, constant) ->
            value(constant)
                .ifPresent(
                    value ->
                        // rosidl puts the constants of a message into a module of this name.
                        values.put(name.replace("_Constants::", "::").replace("::", "."), value)));
    return values;
  }

  private Optional<Object> value(Constant constant) {
    try {
      BigInteger number = value(constant.expression, constant.scope);
      return number.bitLength() < Long.SIZE
          ? Optional.of(number.longValueExact())
          : Optional.empty();
    } catch (NoNumberException e) {
      String text = constant.expression.getText();
      if (text.length() >= 2 && text.startsWith("\"") && text.endsWith("\"")) {
        return Optional.of(text.substring(1, text.length() - 1));
      }
      if (text.equals("TRUE") || text.equals("FALSE")) {
        return Optional.of(text.equals("TRUE"));
      }
      return REAL.matcher(text).matches()
          ? Optional.of(Double.valueOf(text.replaceFirst("[dDfF]$", "")))
          : Optional.empty();
    }
  }

  private BigInteger named(
      String name, String scope, InterfaceDefinitionParser.ScopedNameContext at)
      throws NoNumberException {
    Optional<String> qualified = scopes.find(at, scope, constants::containsKey);
    if (qualified.isEmpty()) {
      throw new NoNumberException("unknown constant '" + name + "'");
    }
    Constant constant = constants.get(qualified.get());
    if (constant.value == null) {
      if (constant.isOpen || chain >= MAX_CHAIN) {
        throw new NoNumberException("the constant '" + name + "' is defined in terms of itself");
      }
      constant.isOpen = true;
      chain++;
      try {
        constant.value = value(constant.expression, constant.scope);
      } finally {
        chain--;
        constant.isOpen = false;
      }
    }
    return constant.value;
  }

  /** Every rule below {@code expression} is a list of operands separated by operators. */
  private BigInteger value(ParserRuleContext rule, String scope) throws NoNumberException {
    if (rule instanceof UnaryContext unary) {
      return unary(unary, scope);
    }
    List<ParseTree> children = rule.children;
    BigInteger value = value((ParserRuleContext) children.get(0), scope);
    StringBuilder operator = new StringBuilder();
    for (ParseTree child : children.subList(1, children.size())) {
      if (child instanceof TerminalNode) {
        operator.append(child.getText());
      } else {
        value = apply(operator.toString(), value, value((ParserRuleContext) child, scope));
        operator.setLength(0);
      }
    }
    return value;
  }

  private BigInteger unary(UnaryContext unary, String scope) throws NoNumberException {
    BigInteger value = primary(unary.primary(), scope);
    for (int i = unary.getChildCount() - 2; i >= 0; i--) {
      value =
          switch (unary.getChild(i).getText()) {
            case "-" -> value.negate();
            case "~" -> value.not();
            default -> value;
          };
    }
    return value;
  }

  private BigInteger primary(PrimaryContext primary, String scope) throws NoNumberException {
    if (primary.INTEGER() != null) {
      return literal(primary.INTEGER().getText());
    }
    if (primary.expression() != null) {
      return value(primary.expression(), scope);
    }
    if (primary.scopedName() != null) {
      return named(primary.scopedName().getText(), scope, primary.scopedName());
    }
    throw new NoNumberException("'" + primary.getText() + "' is not a whole number");
  }

  private static BigInteger literal(String text) throws NoNumberException {
    boolean hexadecimal = text.startsWith("0x") || text.startsWith("0X");
    boolean octal = !hexadecimal && text.length() > 1 && text.startsWith("0");
    String digits = hexadecimal ? text.substring(2) : text;
    if (digits.length() > MAX_BITS / 3 || (octal && digits.matches(".*[89].*"))) {
      throw new NoNumberException("'" + digits.substring(0, 1) + "...' is not a valid number");
    }
    return new BigInteger(digits, hexadecimal ? 16 : octal ? 8 : 10);
  }

  private static BigInteger apply(String operator, BigInteger left, BigInteger right)
      throws NoNumberException {
    BigInteger result =
        switch (operator) {
          case "|" -> left.or(right);
          case "^" -> left.xor(right);
          case "&" -> left.and(right);
          case "<<" -> left.shiftLeft(shift(right));
          case ">>" -> left.shiftRight(shift(right));
          case "+" -> left.add(right);
          case "-" -> left.subtract(right);
          case "*" -> left.multiply(right);
          case "/" -> left.divide(divisor(right));
          case "%" -> left.remainder(divisor(right));
          default -> throw new NoNumberException("'" + operator + "' is not an operator");
        };
    if (result.bitLength() > MAX_BITS) {
      throw new NoNumberException("the constant is too large");
    }
    return result;
  }

  private static int shift(BigInteger by) throws NoNumberException {
    if (by.signum() < 0 || by.bitLength() > 6) {
      throw new NoNumberException("a shift must be by 0 to 63 bits");
    }
    return by.intValueExact();
  }

  private static BigInteger divisor(BigInteger by) throws NoNumberException {
    if (by.signum() == 0) {
      throw new NoNumberException("division by zero");
    }
    return by;
  }

  private static final class Constant {
    private final String scope;
    private final ExpressionContext expression;
    private @Nullable BigInteger value;
    private boolean isOpen;

    Constant(String scope, ExpressionContext expression) {
      this.scope = scope;
      this.expression = expression;
    }
  }

  /** Thrown when an expression is not an integer constant. */
  private static final class NoNumberException extends Exception {
    private static final long serialVersionUID = 1L;

    NoNumberException(String message) {
      super(message);
    }
  }
}
