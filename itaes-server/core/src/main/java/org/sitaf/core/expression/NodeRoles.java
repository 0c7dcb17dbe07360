package org.sitaf.core.expression;

import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelComprehension;
import dev.cel.common.ast.CelExpr.CelMap;
import org.sitaf.core.expression.function.Library;
import org.sitaf.core.expression.function.Signature;

/** Marks the nodes of a syntax tree whose values cost more steps than the node itself. */
final class NodeRoles {
  /** No additional cost. */
  static final byte PLAIN = 0;

  /** The value is compared or hashed as a whole. */
  static final byte COMPARED = 1;

  /** A string that is matched against a regular expression. */
  static final byte SEARCHED = 2;

  /** A regular expression. */
  static final byte PATTERN = 3;

  /** A string, list or other value that an operation creates. */
  static final byte CREATED = 4;

  /** A matrix whose number of cells times its longer side is the work of an operation. */
  static final byte MULTIPLIED = 5;

  private byte[] roles = new byte[64];

  NodeRoles(CelExpr root) {
    visit(root);
    // The result is converted to text as a whole.
    set(root, COMPARED);
  }

  byte of(CelExpr node) {
    long id = node.id();
    return id >= 0 && id < roles.length ? roles[(int) id] : PLAIN;
  }

  private void set(CelExpr node, byte role) {
    int id = (int) node.id();
    if (id >= roles.length) {
      roles = java.util.Arrays.copyOf(roles, Math.max(2 * roles.length, id + 1));
    }
    roles[id] = role;
  }

  private void visit(CelExpr node) {
    switch (node.getKind()) {
      case SELECT -> visit(node.select().operand());
      case LIST -> node.list().elements().forEach(this::visit);
      case STRUCT -> node.struct().entries().forEach(e -> visit(e.value()));
      case MAP -> {
        for (CelMap.Entry entry : node.map().entries()) {
          visit(entry.key());
          visit(entry.value());
          set(entry.key(), COMPARED);
        }
      }
      case COMPREHENSION -> {
        CelComprehension loop = node.comprehension();
        visit(loop.iterRange());
        visit(loop.accuInit());
        visit(loop.loopCondition());
        visit(loop.loopStep());
        visit(loop.result());
        set(node, CREATED);
      }
      case CALL -> call(node);
      default -> {}
    }
  }

  private void call(CelExpr node) {
    set(node, CREATED);
    node.call().target().ifPresent(this::visit);
    node.call().args().forEach(this::visit);
    switch (node.call().function()) {
      case "@equals", "@not_equals", "@member" -> node.call().args().forEach(a -> set(a, COMPARED));
      case "_[_]" -> set(node.call().args().get(1), COMPARED);
      case "matches" -> {
        node.call().target().ifPresent(t -> set(t, SEARCHED));
        if (node.call().args().size() == 2) {
          set(node.call().args().get(0), SEARCHED);
        }
        set(node.call().args().get(node.call().args().size() - 1), PATTERN);
      }
      default -> library(node);
    }
  }

  private void library(CelExpr node) {
    for (Signature signature : Library.signatures(node.call().function())) {
      if (signature.cost() != Signature.Cost.CONSTANT) {
        boolean multiplied = signature.cost() == Signature.Cost.PRODUCT;
        node.call().args().forEach(a -> set(a, multiplied ? MULTIPLIED : COMPARED));
        set(node, COMPARED);
      }
    }
  }
}
