package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;

/**
 * The compiled CEL expressions of a model.
 *
 * @param pre pre-conditions in the order of the model
 * @param expected expected values by output name
 * @param post post-conditions in the order of the model
 */
record Conditions(List<Expression> pre, Map<String, Expression> expected, List<Expression> post) {
  private static final Pattern ERROR = Pattern.compile(Pattern.quote(Value.ERROR_PREFIX) + "\\w+");

  private static final Pattern QUOTED_ERROR = Pattern.compile("(['\"])" + ERROR + "\\1");

  /** Maximum length of all expressions of a model; takes a few seconds to compile. */
  private static final int MAX_CHARACTERS = 500_000;

  Conditions {
    pre = List.copyOf(pre);
    expected = Map.copyOf(expected);
    post = List.copyOf(post);
  }

  /** Compiles all expressions. Invalid expressions are reported and omitted. */
  static Conditions compile(TestModel model, Diagnostics diagnostics) {
    long characters =
        Stream.of(
                model.preConditions().stream().map(Condition::expression),
                model.postConditions().stream().map(Condition::expression),
                model.outputs().stream().map(o -> o.expected() == null ? "" : o.expected()))
            .flatMap(texts -> texts)
            .mapToLong(String::length)
            .sum();
    if (characters > MAX_CHARACTERS) {
      diagnostics.error(
          model.source(),
          0,
          "test_model",
          String.format(
              Locale.ROOT,
              "conditions and expected values have %,d characters in total, but at most %,d are"
                  + " allowed; simplify them",
              characters,
              MAX_CHARACTERS));
      return new Conditions(List.of(), Map.of(), List.of());
    }
    Set<String> before =
        new TreeSet<>(Variables.roots(model.inputs().stream().map(InputElement::name).toList()));
    before.add(Variables.VALID);
    Set<String> after = new TreeSet<>(before);
    after.add("actual");
    after.add(Variables.CALLS);
    model.outputs().forEach(o -> after.add("actual_" + o.name()));
    ExpressionCompiler beforeCall = new ExpressionCompiler(before);
    Compilation compilation = new Compilation(model.source(), diagnostics);
    List<Expression> pre =
        compilation.all(beforeCall, model.preConditions(), "pre_condition_spec_list");
    Map<String, Expression> expected = new TreeMap<>();
    for (OutputElement output : model.outputs()) {
      if (output.expected() != null) {
        compilation
            .one(
                beforeCall,
                new Condition(expression(output.expected()), output.line()),
                "test_element " + output.name() + "/expected")
            .ifPresent(e -> expected.put(output.name(), e));
      }
    }
    List<Expression> post =
        model.postConditions().isEmpty()
            ? List.of()
            : compilation.all(
                new ExpressionCompiler(Variables.roots(after)),
                model.postConditions(),
                "post_condition_spec_list");
    return new Conditions(pre, expected, post);
  }

  /**
   * Quotes an unquoted error, such as {@code !error:NoEcho}. Quoted errors are converted to {@code
   * dyn}, so CEL accepts them next to values of other types.
   */
  private static String expression(String expected) {
    String stripped = expected.strip();
    return ERROR.matcher(stripped).matches()
        ? '"' + stripped + '"'
        : QUOTED_ERROR.matcher(expected).replaceAll("dyn($0)");
  }

  private record Compilation(String source, Diagnostics diagnostics) {
    List<Expression> all(ExpressionCompiler compiler, List<Condition> conditions, String where) {
      List<Expression> compiled = new ArrayList<>();
      conditions.forEach(c -> one(compiler, c, where).ifPresent(compiled::add));
      return compiled;
    }

    Optional<Expression> one(ExpressionCompiler compiler, Condition condition, String where) {
      try {
        return Optional.of(compiler.compile(condition.expression()));
      } catch (IllegalArgumentException e) {
        diagnostics.error(source, condition.line(), where, String.valueOf(e.getMessage()));
        return Optional.empty();
      }
    }
  }
}
