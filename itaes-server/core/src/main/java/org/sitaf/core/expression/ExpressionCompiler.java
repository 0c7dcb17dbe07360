package org.sitaf.core.expression;

import dev.cel.common.CelAbstractSyntaxTree;
import dev.cel.common.CelIssue;
import dev.cel.common.CelValidationException;
import dev.cel.common.types.CelType;
import dev.cel.common.types.ListType;
import dev.cel.common.types.MapType;
import dev.cel.common.types.SimpleType;
import dev.cel.compiler.CelCompiler;
import dev.cel.compiler.CelCompilerBuilder;
import dev.cel.compiler.CelCompilerFactory;
import dev.cel.runtime.CelEvaluationException;
import dev.cel.runtime.CelRuntime;
import dev.cel.runtime.CelRuntimeFactory;
import java.util.Collection;
import java.util.stream.Collectors;

/**
 * Compiles CEL expressions over given variables, within {@link ExpressionLimits}. Integers and
 * floating-point numbers are comparable, so {@code Distance <= 10} works for both types.
 */
public final class ExpressionCompiler {
  /**
   * A map of lists. With type {@code dyn}, CEL would assume that {@code size()} is called on a
   * string.
   */
  private static final CelType CALLS =
      MapType.create(SimpleType.STRING, ListType.create(SimpleType.DYN));

  private final CelCompiler compiler;
  private final CelRuntime runtime;

  /**
   * Creates a compiler for variables. All variables except {@link Variables#CALLS} are dynamically
   * typed.
   */
  public ExpressionCompiler(Collection<String> variables) {
    this(Scope.untyped(variables));
  }

  /** Creates a compiler for the names of a scope. */
  public ExpressionCompiler(Scope scope) {
    CelCompilerBuilder builder =
        CelCompilerFactory.standardCelCompilerBuilder()
            .setOptions(ExpressionLimits.OPTIONS)
            .setStandardMacros(dev.cel.parser.CelStandardMacro.STANDARD_MACROS);
    scope
        .variables()
        .keySet()
        .forEach(
            name -> builder.addVar(name, name.equals(Variables.CALLS) ? CALLS : SimpleType.DYN));
    compiler = builder.build();
    runtime =
        CelRuntimeFactory.standardCelRuntimeBuilder().setOptions(ExpressionLimits.OPTIONS).build();
  }

  /**
   * Compiles an expression.
   *
   * @throws IllegalArgumentException if it is not valid CEL, uses an unknown variable, or exceeds a
   *     limit
   */
  public Expression compile(String text) {
    try {
      CelAbstractSyntaxTree parsed = compiler.parse(text).getAst();
      // Before type checking, which can take exponential time.
      StepEstimate.check(parsed.getExpr());
      return new Expression(text, compiler.check(parsed).getAst(), runtime);
    } catch (IllegalArgumentException e) {
      throw invalid(text, String.valueOf(e.getMessage()), e);
    } catch (CelValidationException e) {
      String issues =
          e.getErrors().stream()
              .map(CelIssue::getMessage)
              .distinct()
              .collect(Collectors.joining("; "));
      throw invalid(text, issues, e);
    } catch (CelEvaluationException e) {
      throw invalid(text, String.valueOf(e.getMessage()), e);
    }
  }

  private static IllegalArgumentException invalid(String text, String why, Exception cause) {
    return new IllegalArgumentException(
        "'" + Expression.shown(text) + "' is not a valid expression: " + why, cause);
  }
}
