package org.sitaf.core.description.idl.preprocessor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * A macro.
 *
 * @param parameters null for a macro without an argument list
 */
record Macro(String name, @Nullable List<String> parameters, List<Lexeme> replacement) {
  private static final String VARIADIC = "...";

  Macro {
    parameters = parameters == null ? null : List.copyOf(parameters);
    replacement = List.copyOf(replacement);
  }

  /** The name under which the last arguments of a variadic macro are replaced. */
  static final String REST = "__VA_ARGS__";

  boolean isVariadic() {
    return parameters != null && parameters.contains(REST);
  }

  /**
   * Reads what follows {@code #define}.
   *
   * @return empty if it is no definition
   */
  static Optional<Macro> read(List<Lexeme> line) {
    if (line.isEmpty() || !line.get(0).isName()) {
      return Optional.empty();
    }
    String name = line.get(0).text();
    // Only a bracket directly after the name begins a parameter list.
    if (line.size() < 2 || !line.get(1).is("(")) {
      return Optional.of(new Macro(name, null, trimmed(line.subList(1, line.size()))));
    }
    List<String> parameters = new ArrayList<>();
    boolean expectsName = true;
    for (int i = 2; i < line.size(); i++) {
      Lexeme lexeme = line.get(i);
      if (lexeme.isSpace()) {
        continue;
      }
      if (lexeme.is(")") && (!expectsName || parameters.isEmpty())) {
        return Optional.of(new Macro(name, parameters, trimmed(line.subList(i + 1, line.size()))));
      }
      if (expectsName && lexeme.isName() && !parameters.contains(REST)) {
        parameters.add(lexeme.text());
      } else if (expectsName && isDots(line, i) && !parameters.contains(REST)) {
        parameters.add(REST);
        i += VARIADIC.length() - 1;
      } else if (expectsName || !lexeme.is(",")) {
        return Optional.empty();
      }
      expectsName = !expectsName;
    }
    return Optional.empty();
  }

  private static boolean isDots(List<Lexeme> line, int at) {
    return at + 2 < line.size()
        && line.subList(at, at + 3).stream().allMatch(lexeme -> lexeme.is("."));
  }

  private static List<Lexeme> trimmed(List<Lexeme> lexemes) {
    int from = 0;
    int to = lexemes.size();
    while (from < to && lexemes.get(from).isSpace()) {
      from++;
    }
    while (to > from && lexemes.get(to - 1).isSpace()) {
      to--;
    }
    return lexemes.subList(from, to);
  }
}
