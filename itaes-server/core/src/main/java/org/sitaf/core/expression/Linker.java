package org.sitaf.core.expression;

import dev.cel.common.ast.CelConstant;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelCall;
import dev.cel.common.ast.CelExpr.CelComprehension;
import dev.cel.common.ast.CelExpr.CelList;
import dev.cel.common.ast.CelExpr.CelMap;
import dev.cel.common.ast.CelExpr.CelSelect;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.expression.function.Library;
import org.sitaf.core.expression.type.TypeCheck;

/**
 * Prepares a parsed expression for its evaluation: constants become literals, names with dots one
 * variable, and operators over numbers those of {@link Library}. Nodes are numbered from 1.
 */
final class Linker {
  private final Scope scope;
  private final Set<String> definitions;
  private final Deque<String> bound = new ArrayDeque<>();
  private final Set<String> variables = new LinkedHashSet<>();
  private final Set<String> used = new LinkedHashSet<>();
  private long id;

  Linker(Scope scope) {
    this.scope = scope;
    this.definitions = scope.definitionNames();
  }

  /** The variables that the linked expressions use. */
  Set<String> variables() {
    return variables;
  }

  /** The definitions that the linked expressions use themselves. */
  Set<String> definitions() {
    return used;
  }

  /** A copy with new numbers. */
  CelExpr link(CelExpr node) {
    return switch (node.getKind()) {
      case IDENT -> name(node.ident().name()).orElseGet(() -> numbered(node));
      case SELECT -> select(node, node.select());
      case CALL -> call(node.call());
      case LIST ->
          numbered(
              node.toBuilder()
                  .setList(
                      CelList.newBuilder()
                          .addElements(node.list().elements().stream().map(this::link).toList())
                          .addOptionalIndices(node.list().optionalIndices())
                          .build())
                  .build());
      case MAP -> map(node);
      case COMPREHENSION -> loop(node.comprehension());
      default -> numbered(node);
    };
  }

  private CelExpr numbered(CelExpr node) {
    return node.toBuilder().setId(++id).build();
  }

  private boolean isBound(String name) {
    return bound.contains(name);
  }

  /** A variable, definition or constant; empty for a name of CEL, such as a type. */
  private Optional<CelExpr> name(String name) {
    if (isBound(name)) {
      return Optional.empty();
    }
    if (scope.variables().containsKey(name)) {
      variables.add(name);
      return Optional.of(CelExpr.ofIdent(++id, name));
    }
    if (definitions.contains(name)) {
      used.add(name);
      return Optional.empty();
    }
    Object constant = scope.constant(name);
    return constant == null
        ? Optional.empty()
        : Optional.of(CelExpr.ofConstant(++id, constant(constant)));
  }

  private static CelConstant constant(Object value) {
    if (value instanceof Long number) {
      return CelConstant.ofValue(number);
    }
    if (value instanceof Double number) {
      return CelConstant.ofValue(number);
    }
    return value instanceof Boolean truth
        ? CelConstant.ofValue(truth)
        : CelConstant.ofValue(String.valueOf(value));
  }

  private CelExpr select(CelExpr node, CelSelect select) {
    Optional<String> dotted = TypeCheck.dotted(node);
    if (dotted.isPresent()
        && !select.testOnly()
        && !isBound(dotted.get().substring(0, dotted.get().indexOf('.')))
        && (scope.variables().containsKey(dotted.get()) || scope.constant(dotted.get()) != null)) {
      return name(dotted.get()).orElseThrow();
    }
    return numbered(
        node.toBuilder()
            .setSelect(select.toBuilder().setOperand(link(select.operand())).build())
            .build());
  }

  private CelExpr call(CelCall call) {
    String name = Library.OPERATORS.getOrDefault(call.function(), call.function());
    CelCall.Builder linked = CelCall.newBuilder().setFunction(name);
    call.target().ifPresent(t -> linked.setTarget(link(t)));
    linked.addArgs(call.args().stream().map(this::link).toList());
    return CelExpr.newBuilder().setId(++id).setCall(linked.build()).build();
  }

  private CelExpr map(CelExpr node) {
    List<CelMap.Entry> entries =
        node.map().entries().stream()
            .map(
                e ->
                    e.toBuilder()
                        .setId(++id)
                        .setKey(link(e.key()))
                        .setValue(link(e.value()))
                        .build())
            .toList();
    return numbered(
        node.toBuilder().setMap(CelMap.newBuilder().addEntries(entries).build()).build());
  }

  private CelExpr loop(CelComprehension loop) {
    CelComprehension.Builder linked =
        loop.toBuilder().setIterRange(link(loop.iterRange())).setAccuInit(link(loop.accuInit()));
    bound.push(loop.accuVar());
    linked.setResult(link(loop.result()));
    bound.push(loop.iterVar());
    bound.push(loop.iterVar2());
    linked.setLoopCondition(link(loop.loopCondition()));
    linked.setLoopStep(step(loop.loopStep(), loop.accuVar()));
    bound.pop();
    bound.pop();
    bound.pop();
    return CelExpr.newBuilder().setId(++id).setComprehension(linked.build()).build();
  }

  /** CEL lets a list that a macro collects grow in place, with its own operator. */
  private CelExpr step(CelExpr step, String accumulator) {
    if (step.getKind() == CelExpr.ExprKind.Kind.CALL) {
      CelCall call = step.call();
      if (call.function().equals("_+_") && isIdent(call.args().get(0), accumulator)) {
        return CelExpr.newBuilder()
            .setId(++id)
            .setCall(
                CelCall.newBuilder()
                    .setFunction("_+_")
                    .addArgs(link(call.args().get(0)), link(call.args().get(1)))
                    .build())
            .build();
      }
      if (call.function().equals("_?_:_")) {
        return CelExpr.newBuilder()
            .setId(++id)
            .setCall(
                CelCall.newBuilder()
                    .setFunction("_?_:_")
                    .addArgs(
                        link(call.args().get(0)),
                        step(call.args().get(1), accumulator),
                        step(call.args().get(2), accumulator))
                    .build())
            .build();
      }
    }
    return link(step);
  }

  private static boolean isIdent(@Nullable CelExpr node, String name) {
    return node != null
        && node.getKind() == CelExpr.ExprKind.Kind.IDENT
        && node.ident().name().equals(name);
  }
}
