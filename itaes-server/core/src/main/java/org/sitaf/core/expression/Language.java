package org.sitaf.core.expression;

import dev.cel.common.CelAbstractSyntaxTree;
import dev.cel.common.CelSource;
import dev.cel.common.CelValidationException;
import dev.cel.common.ast.CelExpr;
import dev.cel.extensions.CelExtensions;
import dev.cel.parser.CelMacro;
import dev.cel.parser.CelParser;
import dev.cel.parser.CelParserFactory;
import dev.cel.parser.CelStandardMacro;
import dev.cel.parser.CelUnparserFactory;
import dev.cel.runtime.CelEvaluationException;
import dev.cel.runtime.CelRuntime;
import dev.cel.runtime.CelRuntimeFactory;
import java.util.Optional;
import org.sitaf.core.expression.function.Library;

/**
 * CEL with the functions of {@link Library}. The planner evaluates expressions that CEL's own
 * checker has not seen: {@link org.sitaf.core.expression.type.TypeCheck} checks them instead.
 */
final class Language {
  private static final CelParser PARSER =
      CelParserFactory.standardCelParserBuilder()
          .setOptions(ExpressionLimits.OPTIONS)
          .setStandardMacros(CelStandardMacro.STANDARD_MACROS)
          .addMacros(listOf("min"), listOf("max"))
          .addLibraries(CelExtensions.bindings())
          .build();

  private static final CelRuntime RUNTIME =
      CelRuntimeFactory.plannerRuntimeBuilder()
          .setOptions(ExpressionLimits.OPTIONS)
          .addFunctionBindings(Library.bindings())
          .build();

  private Language() {}

  /** {@code min(a, b)} is {@code min([a, b])}. */
  private static CelMacro listOf(String function) {
    return CelMacro.newGlobalVarArgMacro(
        function,
        (factory, target, arguments) ->
            arguments.size() < 2
                ? Optional.empty()
                : Optional.of(factory.newGlobalCall(function, factory.newList(arguments))));
  }

  static CelExpr parse(String text) throws CelValidationException {
    return PARSER.parse(text).getAst().getExpr();
  }

  static CelRuntime.Program program(CelExpr expression) throws CelEvaluationException {
    return RUNTIME.createProgram(tree(expression));
  }

  /** The text of a part of an expression; empty if it has no short form. */
  static String text(CelExpr part) {
    try {
      return Expression.shown(CelUnparserFactory.newUnparser().unparse(tree(part)), MAX_PART);
    } catch (RuntimeException e) {
      // The expansion of a macro has no text.
      return "…";
    }
  }

  private static final int MAX_PART = 80;

  private static CelAbstractSyntaxTree tree(CelExpr expression) {
    return CelAbstractSyntaxTree.newParsedAst(expression, CelSource.newBuilder("").build());
  }
}
