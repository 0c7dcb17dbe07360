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
 * Compiles CEL over given variables, within {@link ExpressionLimits}. Whole and floating-point
 * numbers compare across types, so that {@code Distance <= 10} means what it says.
 */
public final class ExpressionCompiler {
  /** Lists by name: with less said, CEL takes what has a size for a string. */
  private static final CelType CALLS =
      MapType.create(SimpleType.STRING, ListType.create(SimpleType.DYN));

  private final CelCompiler compiler;
  private final CelRuntime runtime;

  /**
   * Every variable but the record of calls may hold any value: its type shows when the expression
   * is evaluated.
   */
  public ExpressionCompiler(Collection<String> variables) {
    CelCompilerBuilder builder =
        CelCompilerFactory.standardCelCompilerBuilder()
            .setOptions(ExpressionLimits.OPTIONS)
            .setStandardMacros(dev.cel.parser.CelStandardMacro.STANDARD_MACROS);
    variables.forEach(
        name -> builder.addVar(name, name.equals(Variables.CALLS) ? CALLS : SimpleType.DYN));
    compiler = builder.build();
    runtime =
        CelRuntimeFactory.standardCelRuntimeBuilder().setOptions(ExpressionLimits.OPTIONS).build();
  }

  /**
   * Compiles an expression.
   *
   * @throws IllegalArgumentException when it is not CEL, names an unknown variable, or would take
   *     too much; the message says which
   */
  public Expression compile(String text) {
    try {
      CelAbstractSyntaxTree parsed = compiler.parse(text).getAst();
      // Before the types are worked out: those alone can take for ever.
      StepEstimate.check(parsed.getExpr());
      return new Expression(text, compiler.check(parsed).getAst(), runtime);
    } catch (IllegalArgumentException e) {
      throw notUsable(text, String.valueOf(e.getMessage()), e);
    } catch (CelValidationException e) {
      String issues =
          e.getErrors().stream()
              .map(CelIssue::getMessage)
              .distinct()
              .collect(Collectors.joining("; "));
      throw notUsable(text, issues, e);
    } catch (CelEvaluationException e) {
      throw notUsable(text, String.valueOf(e.getMessage()), e);
    }
  }

  private static IllegalArgumentException notUsable(String text, String why, Exception cause) {
    return new IllegalArgumentException(
        "'" + Expression.shown(text) + "' is not usable: " + why, cause);
  }
}
