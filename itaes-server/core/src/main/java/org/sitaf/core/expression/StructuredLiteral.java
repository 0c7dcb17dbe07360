package org.sitaf.core.expression;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.Value;

/**
 * Parses literals of sequences and structs, such as {@code [1.0, 2.5]} and {@code {x: 1.0, name:
 * "a, b"}}, into lists and maps for CEL.
 */
final class StructuredLiteral {
  private static final int MAX_DEPTH = 64;
  private static final Pattern WHOLE = Pattern.compile("[-+]?\\d{1,18}");
  private static final Pattern REAL =
      Pattern.compile("[-+]?(\\d+\\.?\\d*([eE][-+]?\\d+)?|\\.\\d+|NaN|Infinity)");

  private final String text;
  private int at;
  private int depth;

  private StructuredLiteral(String text) {
    this.text = text;
  }

  /**
   * Parses a literal.
   *
   * @param type type of the literal; if unknown, it is inferred from the text
   * @throws IllegalArgumentException if it is not a valid literal
   */
  static Object plain(String literal, DataType type) {
    if (type instanceof DataType.Scalar || type instanceof DataType.Enumeration) {
      return Variables.plain(Value.parse(literal, type));
    }
    String stripped = literal.strip();
    boolean structured = stripped.startsWith("[") || stripped.startsWith("{");
    if (type instanceof DataType.Unknown && !structured) {
      return untyped(literal);
    }
    StructuredLiteral reading = new StructuredLiteral(stripped);
    Object value = reading.value(type);
    if (reading.at != stripped.length()) {
      throw reading.expected("the end");
    }
    return value;
  }

  private Object value(DataType type) {
    skipBlanks();
    char first = at < text.length() ? text.charAt(at) : ' ';
    if (first == '[' || first == '{') {
      if (++depth > MAX_DEPTH) {
        throw expected("at most " + MAX_DEPTH + " nested levels");
      }
      Object nested = first == '[' ? list(type) : map(type);
      depth--;
      return nested;
    }
    if (first == '"') {
      return typed(quoted(), type, true);
    }
    int from = at;
    while (at < text.length() && ",]}".indexOf(text.charAt(at)) < 0) {
      at++;
    }
    return typed(text.substring(from, at).strip(), type, false);
  }

  private List<Object> list(DataType type) {
    DataType element =
        type instanceof DataType.Sequence sequence
            ? sequence.element()
            : type instanceof DataType.FixedArray array
                ? array.element()
                : new DataType.Unknown("");
    List<Object> values = new ArrayList<>();
    at++;
    if (!takeClosing(']')) {
      do {
        values.add(value(element));
      } while (hasNext(']'));
    }
    return values;
  }

  private Map<String, Object> map(DataType type) {
    Map<String, Object> values = new LinkedHashMap<>();
    at++;
    if (!takeClosing('}')) {
      do {
        skipBlanks();
        int colon = text.indexOf(':', at);
        if (colon < 0) {
          throw expected("a member, such as x: 1.0");
        }
        String name = text.substring(at, colon).strip();
        at = colon + 1;
        values.put(name, value(type.member(name)));
      } while (hasNext('}'));
    }
    return values;
  }

  private String quoted() {
    StringBuilder value = new StringBuilder();
    for (at++; at < text.length() && text.charAt(at) != '"'; at++) {
      if (text.charAt(at) == '\\' && at + 1 < text.length()) {
        at++;
      }
      value.append(text.charAt(at));
    }
    if (at == text.length()) {
      throw expected("a closing quote");
    }
    at++;
    return value.toString();
  }

  private static Object typed(String literal, DataType type, boolean quoted) {
    if (type instanceof DataType.Scalar || type instanceof DataType.Enumeration) {
      return Variables.plain(Value.parse(literal, type));
    }
    return quoted ? literal : untyped(literal);
  }

  private static Object untyped(String literal) {
    if (WHOLE.matcher(literal).matches()) {
      return Long.valueOf(literal.startsWith("+") ? literal.substring(1) : literal);
    }
    if (REAL.matcher(literal).matches()) {
      return Double.valueOf(literal);
    }
    return switch (literal) {
      case "true" -> true;
      case "false" -> false;
      default -> literal;
    };
  }

  private boolean takeClosing(char close) {
    skipBlanks();
    boolean ends = at < text.length() && text.charAt(at) == close;
    at += ends ? 1 : 0;
    return ends;
  }

  private boolean hasNext(char close) {
    if (takeClosing(close)) {
      return false;
    }
    if (at >= text.length() || text.charAt(at) != ',') {
      throw expected("',' or '" + close + "'");
    }
    at++;
    return true;
  }

  private void skipBlanks() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
  }

  private IllegalArgumentException expected(String expected) {
    return new IllegalArgumentException(
        "'"
            + text
            + "' is not a value such as [1.0, 2.5] or {x: 1.0}: at character "
            + (at + 1)
            + " expected "
            + expected);
  }
}
