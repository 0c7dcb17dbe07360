package org.sitaf.core.expression;

import dev.cel.common.ast.CelConstant;
import dev.cel.common.ast.CelExpr;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** Finds the elements of a list that an expression uses. */
final class ListUse {
  private final String variable;
  private final Set<Long> indices = new TreeSet<>();
  private boolean isWhole;

  private ListUse(String variable) {
    this.variable = variable;
  }

  /** The constant indices; empty if the expression uses the list in another way. */
  static Optional<Set<Long>> indices(CelExpr linked, String variable) {
    ListUse use = new ListUse(variable);
    use.visit(linked);
    return use.isWhole ? Optional.empty() : Optional.of(use.indices);
  }

  private void visit(CelExpr node) {
    switch (node.getKind()) {
      case IDENT -> isWhole |= node.ident().name().equals(variable);
      case SELECT -> visit(node.select().operand());
      case CALL -> {
        List<CelExpr> arguments = node.call().args();
        if (isElement(node)) {
          indices.add(arguments.get(1).constant().int64Value());
          return;
        }
        node.call().target().ifPresent(this::visit);
        arguments.forEach(this::visit);
      }
      case LIST -> node.list().elements().forEach(this::visit);
      case MAP ->
          node.map()
              .entries()
              .forEach(
                  entry -> {
                    visit(entry.key());
                    visit(entry.value());
                  });
      case COMPREHENSION -> {
        visit(node.comprehension().iterRange());
        visit(node.comprehension().accuInit());
        visit(node.comprehension().loopCondition());
        visit(node.comprehension().loopStep());
        visit(node.comprehension().result());
      }
      default -> {
        // Constants use no variable.
      }
    }
  }

  private boolean isElement(CelExpr node) {
    if (!node.call().function().equals("_[_]")) {
      return false;
    }
    CelExpr list = node.call().args().get(0);
    CelExpr index = node.call().args().get(1);
    return list.getKind() == CelExpr.ExprKind.Kind.IDENT
        && list.ident().name().equals(variable)
        && index.getKind() == CelExpr.ExprKind.Kind.CONSTANT
        && index.constant().getKind() == CelConstant.Kind.INT64_VALUE;
  }
}
