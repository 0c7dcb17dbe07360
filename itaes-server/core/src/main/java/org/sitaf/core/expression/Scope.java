package org.sitaf.core.expression;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.model.Definition;

/**
 * The names that an expression can use. A variable hides a definition of its name, and both hide a
 * constant. Besides the given constants there are {@code pi e inf nan}.
 *
 * @param variables types by name. A name may contain dots, such as {@code ir1.range}; the longest
 *     name wins.
 * @param definitions named sub-expressions, which may use one another in any order
 * @param constants values by name: Long, Double, Boolean or String. A name may contain dots.
 */
public record Scope(
    Map<String, Type> variables, List<Definition> definitions, Map<String, Object> constants) {
  private static final Map<String, Object> NUMBERS =
      Map.of(
          "pi", Math.PI, "e", Math.E, "inf", Double.POSITIVE_INFINITY, "nan", (Object) Double.NaN);

  public Scope {
    variables = Collections.unmodifiableMap(new LinkedHashMap<>(variables));
    definitions = List.copyOf(definitions);
    constants = Map.copyOf(constants);
  }

  /** A scope without definitions and constants. */
  public static Scope of(Map<String, DataType> variables) {
    Map<String, Type> types = new LinkedHashMap<>();
    variables.forEach((name, type) -> types.put(name, Type.of(type)));
    return new Scope(types, List.of(), Map.of());
  }

  /** A scope of variables with their types in expressions. */
  public static Scope ofTypes(Map<String, Type> variables) {
    return new Scope(variables, List.of(), Map.of());
  }

  /** A scope of variables of unknown types. */
  public static Scope untyped(Iterable<String> variables) {
    Map<String, Type> types = new LinkedHashMap<>();
    variables.forEach(name -> types.put(name, Type.ANY));
    return new Scope(types, List.of(), Map.of());
  }

  /** A copy with further variables, which replace variables of the same name. */
  public Scope with(Map<String, DataType> further) {
    Map<String, Type> types = new LinkedHashMap<>(variables);
    further.forEach((name, type) -> types.put(name, Type.of(type)));
    return new Scope(types, definitions, constants);
  }

  /** A copy with definitions and constants. */
  public Scope with(List<Definition> newDefinitions, Map<String, Object> newConstants) {
    return new Scope(variables, newDefinitions, newConstants);
  }

  /** The value of a constant; null if there is none, or if it is hidden. */
  @Nullable Object constant(String name) {
    int dot = name.indexOf('.');
    String root = dot < 0 ? name : name.substring(0, dot);
    if (variables.containsKey(root) || definitions.stream().anyMatch(d -> d.name().equals(root))) {
      return null;
    }
    Object given = constants.get(name);
    return given == null ? NUMBERS.get(name) : given;
  }

  Set<String> definitionNames() {
    return definitions.stream().map(Definition::name).collect(Collectors.toSet());
  }

  /** All names, for suggestions. */
  Set<String> names() {
    Set<String> names = new LinkedHashSet<>(variables.keySet());
    definitions.forEach(d -> names.add(d.name()));
    names.addAll(new java.util.TreeSet<>(constants.keySet()));
    names.addAll(List.of("pi", "e", "inf", "nan"));
    return names;
  }
}
