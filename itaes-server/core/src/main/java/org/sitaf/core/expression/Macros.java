package org.sitaf.core.expression;

import com.google.common.collect.ImmutableList;
import dev.cel.common.ast.CelConstant;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelComprehension;
import java.util.Optional;

/**
 * Parsed expressions as CEL's macros give them. Their nodes have no numbers, see {@link Linker}.
 */
final class Macros {
  /** The variable of a loop that never runs, with which a macro binds a value to a name. */
  static final String UNUSED = "#unused";

  private static final long NO_ID = 0;

  private Macros() {}

  /** {@code cel.bind(name, value, body)}. */
  static CelExpr bind(String name, CelExpr value, CelExpr body) {
    return CelExpr.ofComprehension(
        NO_ID, UNUSED, list(), name, value, truth(false), ident(name), body);
  }

  /**
   * The first element of a loop for which its body is true or false.
   *
   * @param loop a loop over a list with one variable
   */
  static CelExpr first(CelComprehension loop, CelExpr body, boolean wanted) {
    CelExpr accumulator = ident(loop.accuVar());
    CelExpr taken = call("_+_", accumulator, list(ident(loop.iterVar())));
    CelExpr filtered =
        CelExpr.ofComprehension(
            NO_ID,
            loop.iterVar(),
            loop.iterRange(),
            loop.accuVar(),
            list(),
            truth(true),
            call("_?_:_", body, wanted ? taken : accumulator, wanted ? accumulator : taken),
            accumulator);
    return call("_[_]", filtered, CelExpr.ofConstant(NO_ID, CelConstant.ofValue(0L)));
  }

  private static CelExpr ident(String name) {
    return CelExpr.ofIdent(NO_ID, name);
  }

  private static CelExpr truth(boolean value) {
    return CelExpr.ofConstant(NO_ID, CelConstant.ofValue(value));
  }

  private static CelExpr list(CelExpr... elements) {
    return CelExpr.ofList(NO_ID, ImmutableList.copyOf(elements), ImmutableList.of());
  }

  private static CelExpr call(String function, CelExpr... arguments) {
    return CelExpr.ofCall(NO_ID, Optional.empty(), function, ImmutableList.copyOf(arguments));
  }
}
