package org.sitaf.core.expression.type;

import dev.cel.common.ast.CelConstant;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelCall;
import dev.cel.common.ast.CelExpr.CelComprehension;
import dev.cel.common.ast.CelExpr.CelMap;
import dev.cel.common.ast.CelExpr.CelSelect;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.NearestName;

/**
 * Finds the types of a parsed expression and what is certainly wrong with it: unknown names,
 * members and functions, and operands that an operator does not take. CEL's own checker rejects
 * {@code 2 * x} for a floating-point {@code x} and knows no structs of interfaces.
 */
public final class TypeCheck {
  private final Names names;
  private final Function<CelExpr, String> text;
  private final Map<String, Type> local = new HashMap<>();
  private final Map<Long, Type> types = new HashMap<>();
  private final Set<String> errors = new LinkedHashSet<>();
  private final CallCheck calls;

  /**
   * @param text source text of a part of the expression, for messages
   */
  public TypeCheck(Names names, Function<CelExpr, String> text) {
    this.names = names;
    this.text = text;
    this.calls = new CallCheck(this);
  }

  /** Checks an expression. */
  public Type check(CelExpr expression) {
    return visit(expression);
  }

  /** What is wrong; empty if nothing is. */
  public List<String> errors() {
    return List.copyOf(errors);
  }

  /** Divisions of whole numbers whose result is used as a floating-point number. */
  public List<String> wholeDivisions(CelExpr expression, boolean isRealExpected) {
    return new WholeDivisions(this::typeOf, text).of(expression, isRealExpected);
  }

  /** The type of a part of a checked expression. */
  public Type typeOf(CelExpr node) {
    return types.getOrDefault(node.id(), Type.ANY);
  }

  String text(CelExpr node) {
    return text.apply(node);
  }

  Type error(String message) {
    errors.add(message);
    return Type.ANY;
  }

  Type visit(CelExpr node) {
    Type type =
        switch (node.getKind()) {
          case CONSTANT -> constant(node.constant());
          case IDENT -> ident(node.ident().name());
          case SELECT -> select(node, node.select());
          case CALL -> call(node, node.call());
          case LIST -> list(node);
          case MAP -> map(node.map());
          case COMPREHENSION -> loop(node.comprehension());
          case STRUCT ->
              error(
                  "'"
                      + node.struct().messageName()
                      + "{...}' is not supported; write a struct as {\"x\": 1.0, \"y\": 2.0}");
          default -> Type.ANY;
        };
    types.put(node.id(), type);
    return type;
  }

  private static Type constant(CelConstant constant) {
    return switch (constant.getKind()) {
      case INT64_VALUE, UINT64_VALUE -> Type.WHOLE;
      case DOUBLE_VALUE -> Type.REAL;
      case BOOLEAN_VALUE -> Type.BOOLEAN;
      case STRING_VALUE -> constant.stringValue().startsWith("!") ? Type.OUTCOME : Type.TEXT;
      case NULL_VALUE -> Type.NULL;
      default -> Type.ANY;
    };
  }

  private Type ident(String name) {
    Type bound = local.get(name);
    if (bound != null) {
      return bound;
    }
    return names.find(name).orElseGet(() -> unknown(name));
  }

  private Type unknown(String name) {
    Set<String> known = new LinkedHashSet<>(local.keySet());
    known.removeIf(n -> n.startsWith("@"));
    known.addAll(names.all());
    List<String> qualified = known.stream().filter(n -> n.endsWith("." + name)).toList();
    if (!qualified.isEmpty()) {
      return error(
          "the name '" + name + "' is not unique; write " + String.join(" or ", qualified));
    }
    // The first part of a dotted name may be the wrong one.
    String root = root(name);
    String wrong = known.stream().anyMatch(n -> n.startsWith(root + ".")) ? name : root;
    return error("unknown name '" + wrong + "'" + NearestName.hint(wrong, known));
  }

  private Type select(CelExpr node, CelSelect select) {
    Optional<String> dotted = dotted(node);
    if (dotted.isPresent() && !local.containsKey(root(dotted.get()))) {
      Optional<Type> found = names.find(dotted.get());
      if (found.isPresent()) {
        return select.testOnly() ? Type.BOOLEAN : found.get();
      }
      if (!startsWithName(dotted.get())) {
        return unknown(dotted.get());
      }
    }
    Type operand = visit(select.operand());
    if (select.testOnly() && operand instanceof Type.Members) {
      return Type.BOOLEAN;
    }
    Type member = member(operand, select.field(), select.operand());
    return select.testOnly() ? Type.BOOLEAN : member;
  }

  Type member(Type operand, String field, CelExpr of) {
    if (operand instanceof Type.Members struct) {
      Type member = struct.members().get(field);
      return member != null
          ? member
          : error(
              "'"
                  + text(of)
                  + "' has no member '"
                  + field
                  + "'"
                  + NearestName.hint(field, struct.members().keySet()));
    }
    if (operand instanceof Type.Mapping map) {
      return map.value();
    }
    return operand.isOpen()
        ? Type.ANY
        : error(
            "'" + text(of) + "' is " + a(operand) + " and has no members such as '" + field + "'");
  }

  /** Whether some beginning of a dotted name is a known name. */
  private boolean startsWithName(String dotted) {
    for (int dot = dotted.lastIndexOf('.'); dot > 0; dot = dotted.lastIndexOf('.', dot - 1)) {
      if (names.find(dotted.substring(0, dot)).isPresent()) {
        return true;
      }
    }
    return false;
  }

  /** The names of all functions that are not called behind a value. */
  public static List<String> functions() {
    return CallCheck.functions();
  }

  /** The name of a chain of members of a name, such as {@code pose.position.x}. */
  public static Optional<String> dotted(CelExpr node) {
    if (node.getKind() == CelExpr.ExprKind.Kind.IDENT) {
      return Optional.of(node.ident().name());
    }
    return node.getKind() == CelExpr.ExprKind.Kind.SELECT
        ? dotted(node.select().operand()).map(name -> name + "." + node.select().field())
        : Optional.empty();
  }

  private static String root(String dotted) {
    int dot = dotted.indexOf('.');
    return dot < 0 ? dotted : dotted.substring(0, dot);
  }

  private Type list(CelExpr node) {
    Type element = Type.NOTHING;
    for (CelExpr each : node.list().elements()) {
      Type joined = Type.join(element, visit(each));
      element = joined == null ? Type.ANY : joined;
    }
    return new Type.Sequence(element);
  }

  private Type map(CelMap map) {
    Map<String, Type> members = new LinkedHashMap<>();
    boolean named = true;
    for (CelMap.Entry entry : map.entries()) {
      visit(entry.key());
      Type value = visit(entry.value());
      if (entry.key().getKind() == CelExpr.ExprKind.Kind.CONSTANT
          && entry.key().constant().getKind() == CelConstant.Kind.STRING_VALUE) {
        members.put(entry.key().constant().stringValue(), value);
      } else {
        named = false;
      }
    }
    return named ? new Type.Members("", members) : new Type.Mapping(Type.ANY);
  }

  private Type loop(CelComprehension loop) {
    Type range = visit(loop.iterRange());
    Type key = element(range, loop.iterRange());
    Type start = visit(loop.accuInit());
    Map<String, @Nullable Type> hidden = new LinkedHashMap<>();
    bind(hidden, loop.accuVar(), start);
    visit(loop.loopCondition());
    bind(hidden, loop.iterVar(), key);
    if (!loop.iterVar2().isEmpty()) {
      bind(hidden, loop.iterVar2(), Type.ANY);
    }
    visit(loop.loopCondition());
    Type step = visit(loop.loopStep());
    Type collected = Type.join(start, step);
    local.put(loop.accuVar(), collected == null ? Type.ANY : collected);
    restore(hidden, loop.iterVar());
    Type result = visit(loop.result());
    hidden.keySet().stream().toList().forEach(name -> restore(hidden, name));
    return result;
  }

  private void bind(Map<String, @Nullable Type> hidden, String name, Type type) {
    Type outer = local.put(name, type);
    hidden.putIfAbsent(name, outer);
  }

  private void restore(Map<String, @Nullable Type> hidden, String name) {
    Type outer = hidden.get(name);
    if (outer == null) {
      local.remove(name);
    } else {
      local.put(name, outer);
    }
  }

  private Type element(Type range, CelExpr of) {
    if (range instanceof Type.Sequence sequence) {
      return sequence.element();
    }
    if (range instanceof Type.Members || range instanceof Type.Mapping) {
      return Type.TEXT;
    }
    return range.isOpen()
        ? Type.ANY
        : error("'" + text(of) + "' is " + a(range) + ", but a macro needs a list or a map");
  }

  private Type call(CelExpr node, CelCall call) {
    return calls.visit(node, call);
  }

  /** A type for messages. */
  static String a(Type type) {
    return switch (type.name()) {
      case "int" -> "an int";
      case "null" -> "null";
      default -> "a " + type.name();
    };
  }
}
