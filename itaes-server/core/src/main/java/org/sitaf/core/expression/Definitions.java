package org.sitaf.core.expression;

import dev.cel.common.ast.CelExpr;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sitaf.core.expression.type.Names;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.expression.type.TypeCheck;
import org.sitaf.core.model.Definition;

/** The parsed definitions of a scope and the types of all its names. */
final class Definitions implements Names {
  /** Names of CEL for {@code type(x) == double}. */
  private static final Set<String> TYPES =
      Set.of(
          "bool", "bytes", "double", "int", "list", "map", "null_type", "string", "type", "uint");

  private final Scope scope;
  private final Set<String> names;
  private final Map<String, CelExpr> parsed = new LinkedHashMap<>();
  private final Map<String, Type> types = new LinkedHashMap<>();
  private final Set<String> open = new LinkedHashSet<>();

  Definitions(Scope scope) {
    this.scope = scope;
    this.names = scope.definitionNames();
  }

  /**
   * The parsed expression of a definition.
   *
   * @throws IllegalArgumentException if it is invalid
   */
  CelExpr expression(String name) {
    CelExpr known = parsed.get(name);
    if (known == null) {
      known = ExpressionCompiler.parse(definition(name).expression());
      parsed.put(name, known);
    }
    return known;
  }

  private Definition definition(String name) {
    return scope.definitions().stream()
        .filter(d -> d.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /**
   * The definitions that an expression needs, each after those that it needs itself.
   *
   * @throws IllegalArgumentException if one of them is invalid or defined by itself
   */
  List<String> needed(Set<String> used) {
    List<String> ordered = new ArrayList<>();
    used.forEach(name -> need(name, ordered, new LinkedHashSet<>()));
    return ordered;
  }

  private void need(String name, List<String> ordered, Set<String> path) {
    if (ordered.contains(name)) {
      return;
    }
    if (!path.add(name)) {
      throw new IllegalArgumentException(
          "the definition '"
              + name
              + "' is defined by itself: "
              + String.join(" → ", path)
              + " → "
              + name);
    }
    Linker linker = new Linker(scope);
    linker.link(expression(name));
    linker.definitions().forEach(each -> need(each, ordered, path));
    path.remove(name);
    ordered.add(name);
  }

  @Override
  public Optional<Type> find(String name) {
    Type variable = scope.variables().get(name);
    if (variable != null) {
      return Optional.of(variable);
    }
    if (names.contains(name)) {
      return Optional.of(typeOf(name));
    }
    Object constant = scope.constant(name);
    if (constant != null) {
      return Optional.of(
          constant instanceof Long
              ? Type.WHOLE
              : constant instanceof Double
                  ? Type.REAL
                  : constant instanceof Boolean ? Type.BOOLEAN : Type.TEXT);
    }
    return TYPES.contains(name) ? Optional.of(Type.ANY) : Optional.empty();
  }

  /** The type of a definition; unknown if it is invalid, which is reported where it is used. */
  private Type typeOf(String name) {
    Type known = types.get(name);
    if (known != null) {
      return known;
    }
    if (!open.add(name)) {
      return Type.ANY;
    }
    Type type;
    try {
      type = new TypeCheck(this, Language::text).check(expression(name));
    } catch (IllegalArgumentException e) {
      type = Type.ANY;
    }
    open.remove(name);
    types.put(name, type);
    return type;
  }

  @Override
  public Set<String> all() {
    return scope.names();
  }
}
