package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.core.expression.Scope;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.Definition;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.Relation;
import org.sitaf.core.model.TestModel;

/**
 * The compiled CEL expressions of a model.
 *
 * @param pre pre-conditions in the order of the model
 * @param expected expected values by output name
 * @param post post-conditions in the order of the model
 * @param relations between two runs
 */
public record Conditions(
    List<Expression> pre,
    Map<String, Expression> expected,
    List<Expression> post,
    Relations relations) {
  /** Maximum length of all expressions of a model; takes a few seconds to compile. */
  private static final int MAX_CHARACTERS = 500_000;

  public Conditions {
    pre = List.copyOf(pre);
    expected = Map.copyOf(expected);
    post = List.copyOf(post);
  }

  /** Compiles all expressions. Invalid expressions are reported and omitted. */
  public static Conditions compile(TestModel model, Diagnostics diagnostics) {
    long characters =
        Stream.of(
                model.preConditions().stream().map(Condition::expression),
                model.postConditions().stream().map(Condition::expression),
                model.definitions().stream().map(Definition::expression),
                model.outputs().stream().map(o -> o.expected() == null ? "" : o.expected()),
                model.relations().stream().map(Relation::holds),
                model.relations().stream()
                    .flatMap(r -> r.changes().stream().map(Relation.Change::expression)))
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
      return new Conditions(List.of(), Map.of(), List.of(), Relations.NONE);
    }
    return new Compilation(model, diagnostics).all();
  }

  private static final class Compilation {
    private final TestModel model;
    private final Diagnostics diagnostics;
    private final Set<String> warned = new HashSet<>();

    Compilation(TestModel model, Diagnostics diagnostics) {
      this.model = model;
      this.diagnostics = diagnostics;
    }

    Conditions all() {
      Scope after = CaseScope.afterCall(model);
      Set<String> invalid = definitions(after);
      ExpressionCompiler before =
          new ExpressionCompiler(CaseScope.open(CaseScope.beforeCall(model), invalid));
      List<Expression> pre =
          conditions(
              new ExpressionCompiler(CaseScope.open(CaseScope.ofInputs(model), invalid)),
              model.preConditions(),
              "pre_condition_spec_list");
      Map<String, Expression> expected = new TreeMap<>();
      for (OutputElement output : model.outputs()) {
        if (output.expected() != null) {
          expected(before, output).ifPresent(e -> expected.put(output.name(), e));
        }
      }
      List<Expression> post =
          conditions(
              new ExpressionCompiler(CaseScope.open(after, invalid)),
              model.postConditions(),
              "post_condition_spec_list");
      Relations relations =
          new RelationCompiler(
                  model,
                  before,
                  new ExpressionCompiler(CaseScope.open(CaseScope.betweenRuns(model), invalid)),
                  diagnostics)
              .compile();
      return new Conditions(pre, expected, post, relations);
    }

    /** Checks each definition where it is written. Returns the names of those that are invalid. */
    private Set<String> definitions(Scope scope) {
      Set<String> invalid = new HashSet<>();
      ExpressionCompiler compiler = new ExpressionCompiler(scope);
      for (Definition definition : model.definitions()) {
        String where = "define " + definition.name();
        if (scope.variables().containsKey(definition.name())) {
          diagnostics.warning(
              model.source(),
              definition.line(),
              where,
              "has no effect, since an input or output has this name; rename it");
        }
        if (!model.trajectoryConditions().isEmpty()) {
          // It may use signals, which only those conditions know; they report its problems.
          continue;
        }
        if (model.sequence() != null || !model.surroundings().isEmpty()) {
          // It may use the names of one call, whose expressions report its problems.
          continue;
        }
        Optional<Expression> compiled =
            compile(compiler, definition.expression(), definition.line(), where);
        if (compiled.isEmpty()) {
          invalid.add(definition.name());
        } else {
          warn(compiled.get(), false, definition.line(), where);
        }
      }
      return invalid;
    }

    private List<Expression> conditions(
        ExpressionCompiler compiler, List<Condition> conditions, String where) {
      List<Expression> compiled = new ArrayList<>();
      for (Condition condition : conditions) {
        Optional<Expression> expression =
            compile(compiler, condition.expression(), condition.line(), where);
        if (expression.isEmpty()) {
          continue;
        }
        Type type = expression.get().type();
        if (!type.equals(Type.BOOLEAN) && !type.isOpen()) {
          diagnostics.error(
              model.source(),
              condition.line(),
              where,
              "'"
                  + expression.get().text()
                  + "' must be true or false, but its type is "
                  + type.name());
          continue;
        }
        warn(expression.get(), false, condition.line(), where);
        compiled.add(expression.get());
      }
      return compiled;
    }

    private Optional<Expression> expected(ExpressionCompiler compiler, OutputElement output) {
      String where = "test_element " + output.name() + "/expected";
      Optional<Expression> compiled =
          compile(
              compiler, ExpectedText.expression(output.expected()), output.expectedLine(), where);
      if (compiled.isEmpty()) {
        return compiled;
      }
      Optional<String> problem = ExpectedText.problem(compiled.get(), output.type());
      if (problem.isPresent()) {
        diagnostics.error(model.source(), output.expectedLine(), where, problem.get());
        return Optional.empty();
      }
      boolean isReal =
          output.type() instanceof DataType.Scalar scalar && scalar.type().isFloating();
      warn(compiled.get(), isReal, output.expectedLine(), where);
      return compiled;
    }

    private void warn(Expression expression, boolean isRealExpected, int line, String where) {
      for (String warning : expression.wholeDivisions(isRealExpected)) {
        if (warned.add(line + where + warning)) {
          diagnostics.warning(model.source(), line, where, warning);
        }
      }
    }

    private Optional<Expression> compile(
        ExpressionCompiler compiler, String text, int line, String where) {
      try {
        return Optional.of(compiler.compile(text));
      } catch (IllegalArgumentException e) {
        diagnostics.error(model.source(), line, where, String.valueOf(e.getMessage()));
        return Optional.empty();
      }
    }
  }
}
