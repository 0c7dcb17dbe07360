package org.sitaf.core.expression.type;

import dev.cel.common.ast.CelConstant;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelComprehension;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.sitaf.core.expression.function.Library;
import org.sitaf.core.expression.function.Signature;

/**
 * Finds divisions of two whole numbers whose result is used as a floating-point number: {@code 1 /
 * 2 * x} is 0 for any x.
 */
final class WholeDivisions {
  private final Function<CelExpr, Type> types;
  private final Function<CelExpr, String> text;
  private final List<String> found = new ArrayList<>();

  WholeDivisions(Function<CelExpr, Type> types, Function<CelExpr, String> text) {
    this.types = types;
    this.text = text;
  }

  List<String> of(CelExpr expression, boolean isRealExpected) {
    visit(expression, isRealExpected);
    return found.stream().distinct().toList();
  }

  private void visit(CelExpr node, boolean real) {
    switch (node.getKind()) {
      case SELECT -> visit(node.select().operand(), false);
      case LIST -> {
        boolean hasReal = isReal(types.apply(node));
        node.list().elements().forEach(e -> visit(e, real || hasReal));
      }
      case MAP -> node.map().entries().forEach(e -> visit(e.value(), real));
      case COMPREHENSION -> {
        CelComprehension loop = node.comprehension();
        visit(loop.iterRange(), false);
        visit(loop.accuInit(), false);
        visit(loop.loopCondition(), false);
        visit(loop.loopStep(), real);
        visit(loop.result(), real);
      }
      case CALL -> call(node, real);
      default -> {}
    }
  }

  private void call(CelExpr node, boolean real) {
    List<CelExpr> arguments = node.call().args();
    String function = node.call().function();
    node.call().target().ifPresent(t -> visit(t, false));
    switch (function) {
      case "_/_" -> {
        boolean whole = arguments.stream().allMatch(a -> types.apply(a).equals(Type.WHOLE));
        if (whole && real && !isExact(arguments.get(0), arguments.get(1))) {
          found.add(
              "'"
                  + text.apply(node)
                  + "' divides two whole numbers, so its result is whole; write "
                  + (isConstant(arguments.get(0))
                      ? arguments.get(0).constant().int64Value()
                          + ".0 / "
                          + text.apply(arguments.get(1))
                      : "double("
                          + text.apply(arguments.get(0))
                          + ") / "
                          + text.apply(arguments.get(1)))
                  + " for a fraction");
        }
        operands(arguments, real);
      }
      case "_+_", "_-_", "_*_", "_<_", "_<=_", "_>_", "_>=_", "_==_", "_!=_" ->
          operands(arguments, real && "_+_ _-_ _*_".contains(function));
      case "-_" -> arguments.forEach(a -> visit(a, real));
      case "_?_:_" -> {
        visit(arguments.get(0), false);
        boolean either = real || isReal(types.apply(node));
        visit(arguments.get(1), either);
        visit(arguments.get(2), either);
      }
      default -> {
        List<Signature> signatures = Library.signatures(function);
        boolean takesReal =
            !signatures.isEmpty()
                && (signatures.get(0).result() == Signature.Result.REAL
                    || signatures.get(0).result() == Signature.Result.BOOLEAN);
        boolean hasReal =
            !signatures.isEmpty()
                && (real || arguments.stream().anyMatch(a -> isReal(types.apply(a))));
        arguments.forEach(a -> visit(a, takesReal || hasReal));
      }
    }
  }

  private void operands(List<CelExpr> arguments, boolean real) {
    boolean any = real || arguments.stream().anyMatch(a -> isReal(types.apply(a)));
    arguments.forEach(a -> visit(a, any));
  }

  private static boolean isReal(Type type) {
    return type.equals(Type.REAL)
        || type instanceof Type.Sequence sequence && isReal(sequence.element());
  }

  private static boolean isConstant(CelExpr node) {
    return node.getKind() == CelExpr.ExprKind.Kind.CONSTANT
        && node.constant().getKind() == CelConstant.Kind.INT64_VALUE;
  }

  private static boolean isExact(CelExpr a, CelExpr b) {
    return isConstant(a)
        && isConstant(b)
        && b.constant().int64Value() != 0
        && a.constant().int64Value() % b.constant().int64Value() == 0;
  }
}
