package org.sitaf.core.suite;

import dev.cel.common.values.NullValue;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.Value;

/** Converts results of expressions to the literals of documents. */
public final class ResultLiteral {
  /** The expected value of a method that returns nothing. */
  private static final String NOTHING = "null";

  private ResultLiteral() {}

  /**
   * Converts a result to a literal of the output's type: {@code -1} for a double becomes {@code
   * -1.0}.
   */
  public static String of(Object result, DataType type) {
    if (result instanceof String text && Value.isOutcome(text)) {
      return text;
    }
    if (type.isVoid()) {
      if (!(result instanceof NullValue)) {
        throw new IllegalArgumentException(
            "the method returns nothing; expect null or an error such as \"!error:NAME\", not "
                + result);
      }
      return NOTHING;
    }
    if (result instanceof Map<?, ?> map) {
      return map.entrySet().stream()
          .map(
              e ->
                  e.getKey() + ": " + nested(e.getValue(), type.member(String.valueOf(e.getKey()))))
          .collect(Collectors.joining(", ", "{", "}"));
    }
    if (result instanceof List<?> list) {
      DataType element =
          type instanceof DataType.Sequence sequence
              ? sequence.element()
              : type instanceof DataType.FixedArray array ? array.element() : type;
      return list.stream().map(e -> nested(e, element)).collect(Collectors.joining(", ", "[", "]"));
    }
    return Value.parse(String.valueOf(result), type).literal();
  }

  /** Quotes strings in a list or a map, since they may contain commas. */
  private static String nested(Object result, DataType type) {
    return result instanceof String text && !(type instanceof DataType.Enumeration)
        ? '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"'
        : of(result, type);
  }
}
