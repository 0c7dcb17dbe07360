package org.sitaf.core.description.idl.preprocessor;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.description.idl.preprocessor.Lexeme.Kind;

/**
 * Replaces macros by the algorithm of D. Prosser (X3J11/86-196): each token carries the names of
 * the macros that it came from, which do not replace it again.
 */
final class MacroExpansion {
  /** Maximum nesting of calls in arguments of calls; the expansion recurses once per level. */
  private static final int MAX_DEPTH = 100;

  /**
   * A macro call has no end, or the wrong number of arguments, or the text grows beyond its limit.
   */
  static final class MacroException extends Exception {
    private static final long serialVersionUID = 1L;

    MacroException(String message) {
      super(message);
    }
  }

  private final Map<String, Macro> macros;
  private int budget;
  private int depth;

  /**
   * @param macros by name; may change between calls
   * @param budget maximum number of tokens that all expansions together handle
   */
  MacroExpansion(Map<String, Macro> macros, int budget) {
    this.macros = macros;
    this.budget = budget;
  }

  /**
   * Whether a line ends inside the argument list of a macro call, which the next line continues.
   */
  boolean isOpen(List<Lexeme> line) {
    for (int i = 0; i < line.size(); i++) {
      Macro macro = line.get(i).isName() ? macros.get(line.get(i).text()) : null;
      if (macro == null || macro.parameters() == null) {
        continue;
      }
      int depth = 0;
      boolean called = false;
      for (int j = i + 1; j < line.size() && (called ? depth > 0 : isCall(line.get(j))); j++) {
        called |= line.get(j).is("(");
        depth += line.get(j).is("(") ? 1 : line.get(j).is(")") ? -1 : 0;
      }
      if (called && depth > 0) {
        return true;
      }
    }
    return false;
  }

  private static boolean isCall(Lexeme lexeme) {
    return lexeme.isSpace() || lexeme.is("(");
  }

  /** Replaces all macros in a line. */
  List<Lexeme> expand(List<Lexeme> line) throws MacroException {
    List<Lexeme> output = new ArrayList<>();
    Deque<Lexeme> input = new ArrayDeque<>(line);
    while (!input.isEmpty()) {
      spend(1);
      Lexeme next = input.removeFirst();
      Macro macro = next.isName() ? macros.get(next.text()) : null;
      if (macro == null || next.hidden().contains(next.text())) {
        output.add(next);
      } else if (macro.parameters() == null) {
        Set<String> hidden = with(next.hidden(), macro.name());
        prepend(substitute(macro, List.of(), hidden), input);
      } else if (beginsCall(input)) {
        List<List<Lexeme>> arguments = new ArrayList<>();
        Set<String> hidden = new HashSet<>(next.hidden());
        hidden.retainAll(arguments(macro, input, arguments).hidden());
        prepend(substitute(macro, arguments, with(hidden, macro.name())), input);
      } else {
        output.add(next);
      }
    }
    return output;
  }

  private static boolean beginsCall(Deque<Lexeme> input) {
    return input.stream().filter(lexeme -> !lexeme.isSpace()).findFirst().stream()
        .anyMatch(lexeme -> lexeme.is("("));
  }

  /** Takes a call's arguments from the input; the result is its closing bracket. */
  private Lexeme arguments(Macro macro, Deque<Lexeme> input, List<List<Lexeme>> arguments)
      throws MacroException {
    while (!input.removeFirst().is("(")) {
      // White space before the bracket.
    }
    int depth = 1;
    List<Lexeme> current = new ArrayList<>();
    int expected = Objects.requireNonNull(macro.parameters()).size();
    while (!input.isEmpty()) {
      spend(1);
      Lexeme next = input.removeFirst();
      depth += next.is("(") ? 1 : next.is(")") ? -1 : 0;
      boolean rest = macro.isVariadic() && arguments.size() == expected - 1;
      if (depth == 0 || depth == 1 && next.is(",") && !rest) {
        arguments.add(current);
        current = new ArrayList<>();
      } else {
        current.add(next);
      }
      if (depth == 0) {
        complete(macro, arguments, expected);
        return next;
      }
    }
    throw new MacroException("the call of the macro " + macro.name() + " has no closing bracket");
  }

  private static void complete(Macro macro, List<List<Lexeme>> arguments, int expected)
      throws MacroException {
    boolean empty = arguments.size() == 1 && arguments.get(0).stream().allMatch(Lexeme::isSpace);
    if (expected == 0 && empty) {
      arguments.clear();
    } else if (macro.isVariadic() && arguments.size() == expected - 1) {
      arguments.add(List.of());
    }
    if (arguments.size() != expected) {
      throw new MacroException(
          "the macro %s takes %d arguments, but is called with %d"
              .formatted(macro.name(), expected, arguments.size()));
    }
  }

  private List<Lexeme> substitute(Macro macro, List<List<Lexeme>> arguments, Set<String> hidden)
      throws MacroException {
    List<Lexeme> output = new ArrayList<>();
    List<Lexeme> body = macro.replacement();
    for (int i = 0; i < body.size(); i++) {
      Lexeme lexeme = body.get(i);
      int operand = next(body, i + 1);
      if (lexeme.is("#") && operand < body.size() && parameter(macro, body.get(operand)) >= 0) {
        output.add(stringOf(arguments.get(parameter(macro, body.get(operand)))));
        i = operand;
      } else if (lexeme.is("##") && !output.isEmpty() && operand < body.size()) {
        paste(output, argumentOr(macro, body.get(operand), arguments));
        i = operand;
      } else if (parameter(macro, lexeme) >= 0) {
        List<Lexeme> argument = arguments.get(parameter(macro, lexeme));
        boolean pasted = operand < body.size() && body.get(operand).is("##");
        output.addAll(pasted ? argument : expandArgument(argument));
      } else {
        output.add(lexeme);
      }
      spend(1);
    }
    // The sets of hidden names are copied for each token.
    spend(output.size() * (1 + hidden.size() / 8));
    return output.stream()
        .map(lexeme -> new Lexeme(lexeme.kind(), lexeme.text(), with(lexeme.hidden(), hidden)))
        .collect(Collectors.toList());
  }

  private List<Lexeme> expandArgument(List<Lexeme> argument) throws MacroException {
    if (depth >= MAX_DEPTH) {
      throw new MacroException("macro calls nest deeper than " + MAX_DEPTH + " levels");
    }
    depth++;
    try {
      return expand(argument);
    } finally {
      depth--;
    }
  }

  private static int next(List<Lexeme> body, int from) {
    int at = from;
    while (at < body.size() && body.get(at).isSpace()) {
      at++;
    }
    return at;
  }

  private static int parameter(Macro macro, Lexeme lexeme) {
    List<String> parameters = macro.parameters();
    return parameters == null || !lexeme.isName() ? -1 : parameters.indexOf(lexeme.text());
  }

  private static List<Lexeme> argumentOr(Macro macro, Lexeme lexeme, List<List<Lexeme>> arguments) {
    int parameter = parameter(macro, lexeme);
    return parameter < 0 ? List.of(lexeme) : arguments.get(parameter);
  }

  /** Joins the last token of the output with the first of the right side. */
  private static void paste(List<Lexeme> output, List<Lexeme> right) {
    while (!output.isEmpty() && output.get(output.size() - 1).isSpace()) {
      output.remove(output.size() - 1);
    }
    int from = next(right, 0);
    if (from >= right.size()) {
      return;
    }
    String left = output.isEmpty() ? "" : output.remove(output.size() - 1).text();
    output.addAll(Lexeme.split(left + right.get(from).text()));
    output.addAll(right.subList(from + 1, right.size()));
  }

  private static Lexeme stringOf(List<Lexeme> argument) {
    String text = Lexeme.text(argument).strip().replace("\\", "\\\\").replace("\"", "\\\"");
    return new Lexeme(Kind.LITERAL, '"' + text + '"');
  }

  private static void prepend(List<Lexeme> lexemes, Deque<Lexeme> input) {
    for (int i = lexemes.size() - 1; i >= 0; i--) {
      input.addFirst(lexemes.get(i));
    }
  }

  private void spend(int tokens) throws MacroException {
    budget -= tokens;
    if (budget < 0) {
      throw new MacroException(
          "the macros of this file expand to too much text; write the declarations out");
    }
    if (Thread.currentThread().isInterrupted()) {
      throw new MacroException("the reading was interrupted");
    }
  }

  private static Set<String> with(Set<String> names, String name) {
    return with(names, Set.of(name));
  }

  private static Set<String> with(Set<String> names, Set<String> more) {
    if (names.containsAll(more)) {
      return names;
    }
    Set<String> all = new HashSet<>(names);
    all.addAll(more);
    return all;
  }
}
