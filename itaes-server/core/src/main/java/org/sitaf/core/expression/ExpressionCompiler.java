package org.sitaf.core.expression;

import dev.cel.common.CelIssue;
import dev.cel.common.CelValidationException;
import dev.cel.common.ast.CelExpr;
import dev.cel.runtime.CelEvaluationException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.expression.type.TypeCheck;

/**
 * Compiles expressions over the names of a scope, within {@link ExpressionLimits}. What can be
 * checked is checked here: names, members, functions and types.
 */
public final class ExpressionCompiler {
  private final Scope scope;
  private final Definitions definitions;

  /** Creates a compiler for variables of unknown types. */
  public ExpressionCompiler(Collection<String> variables) {
    this(Scope.untyped(variables));
  }

  /** Creates a compiler for the names of a scope. */
  public ExpressionCompiler(Scope scope) {
    this.scope = scope;
    this.definitions = new Definitions(scope);
  }

  /**
   * Compiles an expression.
   *
   * @throws IllegalArgumentException if it is not valid CEL, uses an unknown name, combines types
   *     that do not fit, or exceeds a limit
   */
  public Expression compile(String text) {
    try {
      CelExpr parsed = parse(text);
      Expression.Source source = new Expression.Source(Expression.shown(text), scope, definitions);
      // Before the types are checked, which takes as long as the types are large.
      StepEstimate.check(source.withDefinitions(parsed));
      TypeCheck check = new TypeCheck(definitions, Language::text);
      Type type = check.check(parsed);
      List<String> errors = new ArrayList<>(check.errors());
      for (String used : source.needed(parsed)) {
        TypeCheck definition = new TypeCheck(definitions, Language::text);
        definition.check(definitions.expression(used));
        definition.errors().forEach(e -> errors.add("in the definition '" + used + "': " + e));
      }
      if (!errors.isEmpty()) {
        throw new IllegalArgumentException(String.join("; ", errors));
      }
      return new Expression(source, parsed, type, check);
    } catch (IllegalArgumentException | CelEvaluationException e) {
      throw new IllegalArgumentException(
          "'"
              + Expression.shown(text)
              + "' is not a valid expression: "
              + Expression.shown(String.valueOf(e.getMessage())),
          e);
    }
  }

  static CelExpr parse(String text) {
    try {
      return Language.parse(text);
    } catch (CelValidationException e) {
      throw new IllegalArgumentException(
          Messages.ofSyntax(text, e.getErrors().stream().map(CelIssue::getMessage).toList()), e);
    }
  }

  /** A list in reverse order. */
  static List<String> reversed(List<String> list) {
    List<String> reversed = new ArrayList<>(list);
    Collections.reverse(reversed);
    return reversed;
  }
}
