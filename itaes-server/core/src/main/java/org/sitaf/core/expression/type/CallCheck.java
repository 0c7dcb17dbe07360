package org.sitaf.core.expression.type;

import dev.cel.common.ast.CelConstant;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.ast.CelExpr.CelCall;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.expression.function.Library;
import org.sitaf.core.expression.function.Signature;

/** Checks operators and functions. */
final class CallCheck {
  /** CEL's own functions and the types of their results. */
  private static final Map<String, Type> STANDARD =
      Map.ofEntries(
          Map.entry("size", Type.WHOLE),
          Map.entry("int", Type.WHOLE),
          Map.entry("uint", Type.WHOLE),
          Map.entry("double", Type.REAL),
          Map.entry("string", Type.TEXT),
          Map.entry("bool", Type.BOOLEAN),
          Map.entry("bytes", Type.ANY),
          Map.entry("type", Type.ANY),
          Map.entry("dyn", Type.ANY),
          Map.entry("matches", Type.BOOLEAN),
          Map.entry("contains", Type.BOOLEAN),
          Map.entry("startsWith", Type.BOOLEAN),
          Map.entry("endsWith", Type.BOOLEAN));

  /** Functions of CEL that are written behind a value. */
  private static final Map<String, Integer> RECEIVER =
      Map.of("size", 0, "matches", 1, "contains", 1, "startsWith", 1, "endsWith", 1);

  private static final List<String> MACROS =
      List.of("has", "all", "exists", "exists_one", "map", "filter");

  /** The names of all functions that are not called behind a value. */
  static List<String> functions() {
    List<String> known = new ArrayList<>(Library.names());
    known.addAll(new TreeSet<>(STANDARD.keySet()));
    known.addAll(MACROS);
    return known;
  }

  private final TypeCheck check;

  CallCheck(TypeCheck check) {
    this.check = check;
  }

  Type visit(CelExpr node, CelCall call) {
    List<Type> types = new ArrayList<>();
    call.target().ifPresent(t -> types.add(check.visit(t)));
    call.args().forEach(a -> types.add(check.visit(a)));
    return call.target().isPresent()
        ? receiver(call, types)
        : switch (call.function()) {
          case "_&&_", "_||_", "!_" -> booleans(call, types);
          case "@not_strictly_false" -> Type.BOOLEAN;
          case "_?_:_" -> conditional(call, types);
          case "_<_", "_<=_", "_>_", "_>=_" -> ordered(node, call, types.get(0), types.get(1));
          case "_==_", "_!=_" -> equal(node, types.get(0), types.get(1));
          case "_+_" -> sum(node, types.get(0), types.get(1));
          case "_-_", "_*_", "_/_", "_%_" -> numbers(node, call, types.get(0), types.get(1));
          case "-_" ->
              types.get(0).mayBeNumber()
                  ? types.get(0)
                  : check.error(
                      "'"
                          + check.text(node)
                          + "' needs a number, not "
                          + TypeCheck.a(types.get(0)));
          case "_[_]" -> index(call, types.get(0), types.get(1));
          case "@in" -> contained(node, types.get(0), types.get(1));
          default -> function(node, call, types);
        };
  }

  private Type booleans(CelCall call, List<Type> types) {
    for (int i = 0; i < types.size(); i++) {
      requireBoolean(call.args().get(i), types.get(i), operator(call.function()));
    }
    return Type.BOOLEAN;
  }

  private void requireBoolean(CelExpr argument, Type type, String operator) {
    if (!type.equals(Type.BOOLEAN) && !type.isOpen()) {
      check.error(
          operator
              + " needs true or false, but '"
              + check.text(argument)
              + "' is "
              + TypeCheck.a(type));
    }
  }

  private Type conditional(CelCall call, List<Type> types) {
    requireBoolean(call.args().get(0), types.get(0), "?:");
    Type joined = Type.join(types.get(1), types.get(2));
    return joined != null
        ? joined
        : check.error(
            "the branches of ?: have different types: '"
                + check.text(call.args().get(1))
                + "' is "
                + TypeCheck.a(types.get(1))
                + ", and '"
                + check.text(call.args().get(2))
                + "' is "
                + TypeCheck.a(types.get(2)));
  }

  private Type ordered(CelExpr node, CelCall call, Type a, Type b) {
    boolean fits =
        a.mayBeNumber() && b.mayBeNumber()
            || isText(a) && isText(b)
            || isOrEmpty(a, Type.BOOLEAN) && isOrEmpty(b, Type.BOOLEAN);
    if (!fits) {
      mismatch(node, operator(call.function()) + " does not compare", a, b);
    }
    return Type.BOOLEAN;
  }

  private static boolean isText(Type type) {
    return isOrEmpty(type, Type.TEXT) || type.equals(Type.OUTCOME);
  }

  private static boolean isOrEmpty(Type type, Type wanted) {
    return type.equals(wanted) || type.isOpen();
  }

  private Type equal(CelExpr node, Type a, Type b) {
    if (Type.join(a, b) == null) {
      mismatch(node, "never equal are", a, b);
    }
    return Type.BOOLEAN;
  }

  private Type mismatch(CelExpr node, String problem, Type a, Type b) {
    return check.error(
        "'" + check.text(node) + "': " + problem + " " + TypeCheck.a(a) + " and " + TypeCheck.a(b));
  }

  private Type sum(CelExpr node, Type a, Type b) {
    if (a instanceof Type.Sequence && b instanceof Type.Sequence) {
      Type joined = Type.join(a, b);
      return joined == null ? new Type.Sequence(Type.ANY) : joined;
    }
    if (a.isOpen() || b.isOpen()) {
      return a instanceof Type.Sequence || isText(a) && !a.isOpen()
          ? a
          : b.mayBeNumber() ? Type.ANY : b;
    }
    if (isText(a) && isText(b)) {
      // What begins like an outcome is one: "!error:" + name.
      return a.equals(Type.OUTCOME) ? a : Type.TEXT;
    }
    return a.mayBeNumber() && b.mayBeNumber()
        ? number(a, b)
        : mismatch(node, "+ does not add", a, b);
  }

  private Type numbers(CelExpr node, CelCall call, Type a, Type b) {
    boolean fits = a.mayBeNumber() && b.mayBeNumber();
    if (call.function().equals("_%_")) {
      fits &= !a.equals(Type.REAL) && !b.equals(Type.REAL);
      return fits ? Type.WHOLE : mismatch(node, "% needs two whole numbers, not", a, b);
    }
    return fits
        ? number(a, b)
        : mismatch(node, operator(call.function()) + " needs two numbers, not", a, b);
  }

  private static Type number(Type a, Type b) {
    if (a.equals(Type.REAL) || b.equals(Type.REAL)) {
      return Type.REAL;
    }
    return a.isOpen() || b.isOpen() ? Type.ANY : Type.WHOLE;
  }

  private Type index(CelCall call, Type container, Type index) {
    CelExpr of = call.args().get(0);
    if (container instanceof Type.Sequence sequence) {
      return index.mayBeNumber()
          ? sequence.element()
          : check.error(
              "an index of '" + check.text(of) + "' must be a number, not " + TypeCheck.a(index));
    }
    if (container instanceof Type.Mapping map) {
      return map.value();
    }
    if (container instanceof Type.Members) {
      CelExpr key = call.args().get(1);
      return key.getKind() == CelExpr.ExprKind.Kind.CONSTANT
              && key.constant().getKind() == CelConstant.Kind.STRING_VALUE
          ? check.member(container, key.constant().stringValue(), of)
          : Type.ANY;
    }
    return container.isOpen()
        ? Type.ANY
        : check.error(
            "'" + check.text(of) + "' is " + TypeCheck.a(container) + " and has no elements");
  }

  private Type contained(CelExpr node, Type value, Type container) {
    if (container instanceof Type.Sequence sequence) {
      if (Type.join(value, sequence.element()) == null) {
        mismatch(node, "never contained is", value, container);
      }
    } else if (!(container instanceof Type.Members
        || container instanceof Type.Mapping
        || container.isOpen())) {
      mismatch(node, "in needs a list or a map, not", value, container);
    }
    return Type.BOOLEAN;
  }

  private Type receiver(CelCall call, List<Type> types) {
    String name = call.function();
    Integer arguments = RECEIVER.get(name);
    if (arguments == null) {
      if (!Library.signatures(name).isEmpty() || STANDARD.containsKey(name)) {
        return check.error("call the function as " + name + "(...), not behind a value");
      }
      List<String> known = new ArrayList<>(MACROS);
      known.addAll(new TreeSet<>(RECEIVER.keySet()));
      return check.error("unknown function '" + name + "'" + NearestName.hint(name, known));
    }
    if (call.args().size() != arguments) {
      return check.error(name + " takes " + arguments + " arguments, not " + call.args().size());
    }
    Type of = types.get(0);
    if (name.equals("size")) {
      return sized(check.text(call.target().orElseThrow()), of);
    }
    return strings(name, of, types.get(1));
  }

  private Type strings(String name, Type a, Type b) {
    return isText(a) && isText(b)
        ? Type.BOOLEAN
        : check.error(
            name + " needs two strings, not " + TypeCheck.a(a) + " and " + TypeCheck.a(b));
  }

  private Type sized(String what, Type type) {
    boolean fits =
        isText(type)
            || type instanceof Type.Sequence
            || type instanceof Type.Members
            || type instanceof Type.Mapping;
    return fits
        ? Type.WHOLE
        : check.error("'" + what + "' is " + TypeCheck.a(type) + " and has no size");
  }

  private Type function(CelExpr node, CelCall call, List<Type> types) {
    String name = call.function();
    Type standard = STANDARD.get(name);
    if (standard != null && !name.equals("contains") && !name.endsWith("With")) {
      int wanted = name.equals("matches") ? 2 : 1;
      if (types.size() != wanted) {
        return check.error(name + " takes " + wanted + " arguments, not " + types.size());
      }
      if (name.equals("matches")) {
        return strings(name, types.get(0), types.get(1));
      }
      return name.equals("size") ? sized(check.text(call.args().get(0)), types.get(0)) : standard;
    }
    List<Signature> signatures = Library.signatures(name);
    if (signatures.isEmpty()) {
      return check.error("unknown function '" + name + "'" + NearestName.hint(name, functions()));
    }
    return library(node, call, types, signatures);
  }

  private Type library(CelExpr node, CelCall call, List<Type> types, List<Signature> signatures) {
    String problem = "";
    for (Signature signature : signatures) {
      String mismatch = mismatch(call, types, signature);
      if (mismatch == null) {
        return result(signature, types);
      }
      if (problem.isEmpty() || types.size() == signature.parameters().size()) {
        problem = mismatch;
      }
    }
    return check.error("'" + check.text(node) + "': " + problem);
  }

  private @Nullable String mismatch(CelCall call, List<Type> types, Signature signature) {
    List<Signature.Kind> kinds = signature.parameters();
    if (types.size() != kinds.size()) {
      return signature.name()
          + " takes "
          + Library.signatures(signature.name()).stream()
              .map(Signature::text)
              .collect(Collectors.joining(" or "));
    }
    for (int i = 0; i < kinds.size(); i++) {
      if (!Kinds.fits(types.get(i), kinds.get(i))) {
        return signature.name()
            + " needs "
            + kinds.get(i).text()
            + ", but '"
            + check.text(call.args().get(i))
            + "' is "
            + TypeCheck.a(types.get(i));
      }
    }
    if (signature.name().equals("near") && Type.join(types.get(0), types.get(1)) == null) {
      return "near never holds for "
          + TypeCheck.a(types.get(0))
          + " and "
          + TypeCheck.a(types.get(1));
    }
    return call.args().stream()
        .flatMap(argument -> numbersOnly(signature, argument).stream())
        .findFirst()
        .orElse(null);
  }

  /** What is wrong with a written list, such as {@code [a, "x"]}, where only numbers fit. */
  private Optional<String> numbersOnly(Signature signature, CelExpr argument) {
    boolean isNumbers =
        signature.parameters().stream()
            .allMatch(k -> k == Signature.Kind.LIST || k == Signature.Kind.VECTOR);
    if (!isNumbers || argument.getKind() != CelExpr.ExprKind.Kind.LIST) {
      return Optional.empty();
    }
    return argument.list().elements().stream()
        .filter(element -> !check.typeOf(element).mayBeNumber())
        .findFirst()
        .map(
            element ->
                signature.name()
                    + " needs numbers, but '"
                    + check.text(element)
                    + "' is "
                    + TypeCheck.a(check.typeOf(element)));
  }

  private static Type result(Signature signature, List<Type> types) {
    return switch (signature.result()) {
      case REAL -> Type.REAL;
      case BOOLEAN -> Type.BOOLEAN;
      case MATRIX -> new Type.Sequence(new Type.Sequence(Type.REAL));
      case FORM -> form(types.get(0));
      case LAST_FORM -> form(types.get(types.size() - 1));
      case SAME -> {
        Type joined = Type.NOTHING;
        for (Type type : types) {
          joined =
              number(joined.equals(Type.NOTHING) ? Kinds.number(type) : joined, Kinds.number(type));
        }
        yield joined;
      }
    };
  }

  /** A vector or quaternion of floating-point numbers in the form of another one. */
  private static Type form(Type type) {
    if (type instanceof Type.Members struct) {
      Map<String, Type> members = new java.util.LinkedHashMap<>();
      for (String name : List.of("x", "y", "z", "w")) {
        if (struct.members().containsKey(name)) {
          members.put(name, Type.REAL);
        }
      }
      return new Type.Members("", members);
    }
    return type instanceof Type.Sequence ? new Type.Sequence(Type.REAL) : Type.ANY;
  }

  private static String operator(String function) {
    return function.replace("_", "");
  }
}
