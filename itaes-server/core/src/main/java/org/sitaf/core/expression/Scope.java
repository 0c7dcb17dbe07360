package org.sitaf.core.expression;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.sitaf.core.description.DataType;

/**
 * The names that an expression can use. A variable hides a definition of its name, and both hide a
 * constant.
 *
 * @param variables types by name; {@link DataType.Unknown} if the type is not known. A name may
 *     contain dots, such as {@code ir1.range}; the longest name wins.
 * @param definitions named sub-expressions, which may use one another in any order
 * @param constants values by name: Long, Double, Boolean or String. A name may contain dots.
 */
public record Scope(
    Map<String, DataType> variables, List<Definition> definitions, Map<String, Object> constants) {
  public Scope {
    variables = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(variables));
    definitions = List.copyOf(definitions);
    constants = Map.copyOf(constants);
  }

  /** A scope without definitions and constants. */
  public static Scope of(Map<String, DataType> variables) {
    return new Scope(variables, List.of(), Map.of());
  }

  /** A scope of variables of unknown types. */
  public static Scope untyped(Iterable<String> variables) {
    Map<String, DataType> types = new LinkedHashMap<>();
    variables.forEach(name -> types.put(name, new DataType.Unknown("")));
    return of(types);
  }

  /** A copy with further variables, which replace variables of the same name. */
  public Scope with(Map<String, DataType> further) {
    Map<String, DataType> all = new LinkedHashMap<>(variables);
    all.putAll(further);
    return new Scope(all, definitions, constants);
  }

  /**
   * A named sub-expression.
   *
   * @param line line in the model, from 1; 0 if unknown
   */
  public record Definition(String name, String expression, int line) {
    public Definition {
      Objects.requireNonNull(name);
      Objects.requireNonNull(expression);
    }
  }

  /** All names, for suggestions. */
  Set<String> names() {
    Set<String> names = new LinkedHashSet<>(variables.keySet());
    names.addAll(new ArrayList<>(definitions).stream().map(Definition::name).toList());
    names.addAll(constants.keySet());
    return names;
  }
}
