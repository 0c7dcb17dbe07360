package org.sitaf.core.expression;

import dev.cel.runtime.CelEvaluationException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/** Messages of failed evaluations. */
final class Messages {
  private static final Pattern EXPECTED = Pattern.compile(" expecting (\\{.*\\}|<EOF>)");
  private static final Pattern QUOTED = Pattern.compile("'[^']*'|\"[^\"]*\"");
  private static final Map<Pattern, String> OPERATORS = new LinkedHashMap<>();

  static {
    OPERATORS.put(Pattern.compile("\\band\\b"), "write && for 'and'");
    OPERATORS.put(Pattern.compile("\\bor\\b"), "write || for 'or'");
    OPERATORS.put(Pattern.compile("\\bnot\\b"), "write ! for 'not'");
    OPERATORS.put(Pattern.compile("(?<![=<>!])=(?!=)"), "write == to compare");
  }

  private Messages() {}

  /**
   * The parser's messages without the tokens that it expected, which are nearly all there are, and
   * how to write an operator of another language.
   */
  static String ofSyntax(String text, List<String> messages) {
    List<String> all =
        new ArrayList<>(
            messages.stream().map(m -> EXPECTED.matcher(m).replaceAll("")).distinct().toList());
    String code = QUOTED.matcher(text).replaceAll("");
    OPERATORS.forEach(
        (pattern, advice) -> {
          if (pattern.matcher(code).find()) {
            all.add(advice);
          }
        });
    return String.join("; ", all);
  }

  /** CEL's message without the position, which counts in the expression after its expansion. */
  static String of(CelEvaluationException e) {
    String message =
        String.valueOf(e.getMessage()).replaceFirst("^evaluation error(?: at \\S+)?: ", "");
    if (!message.startsWith("Function '")) {
      return message;
    }
    // A function's own message says more than the name of its overload.
    Throwable cause = e;
    while (cause.getCause() != null) {
      cause = cause.getCause();
    }
    return String.valueOf(cause.getMessage());
  }
}
