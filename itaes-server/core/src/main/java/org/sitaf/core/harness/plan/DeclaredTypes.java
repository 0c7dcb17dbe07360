package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * Collects the structs and enumerations that interfaces use, in the order of their dependencies.
 */
final class DeclaredTypes {
  private final Diagnostics diagnostics;
  private final Map<String, DataType> byName = new HashMap<>();
  private final Map<String, DataType> bySimpleName = new HashMap<>();
  private final List<DataType> inOrder = new ArrayList<>();

  DeclaredTypes(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /** Adds the types of a method. */
  void reach(String source, Method method) {
    Place place = new Place(source, method.line(), "method " + method.name());
    reach(place, method.returnType());
    method.parameters().forEach(p -> reach(place, p.type()));
  }

  /** Adds the type of a data port. */
  void reach(String source, Port.Data port) {
    reach(new Place(source, 0, "data_port " + port.name()), port.type());
  }

  List<DataType> inOrder() {
    return inOrder;
  }

  private void reach(Place place, DataType type) {
    if (type instanceof DataType.Unknown) {
      problem(place, type.typeName() + " is not defined in any document of the activity");
      return;
    }
    boolean declared = type instanceof DataType.Struct || type instanceof DataType.Enumeration;
    if (declared && byName.containsKey(type.typeName())) {
      if (!byName.get(type.typeName()).equals(type)) {
        problem(place, "two different types are named " + type.typeName());
      }
      return;
    }
    if (declared) {
      byName.put(type.typeName(), type);
      name(place, type);
      words(place, type);
    }
    type.parts().forEach(part -> reach(place, part));
    if (declared) {
      inOrder.add(type);
    }
  }

  /**
   * Checks the simple name of a type: it must be an identifier and unique, since generated code has
   * no scopes.
   */
  private void name(Place place, DataType type) {
    String simple = HarnessPlan.simpleName(type);
    if (!Words.isWord(simple)) {
      problem(place, "the type " + type.typeName() + " has a name that is not an identifier");
    } else if (bySimpleName.putIfAbsent(simple, type) != null) {
      problem(
          place,
          type.typeName()
              + " and "
              + bySimpleName.get(simple).typeName()
              + " have the same name in a test");
    }
  }

  private void words(Place place, DataType type) {
    List<String> names =
        type instanceof DataType.Struct struct
            ? struct.members().stream().map(DataType.Member::name).toList()
            : type instanceof DataType.Enumeration enumeration ? enumeration.literals() : List.of();
    Set<String> seen = new HashSet<>();
    for (String name : names) {
      if (!Words.isWord(name)) {
        problem(place, type.typeName() + ": '" + name + "' is not an identifier");
      } else if (!seen.add(name)) {
        problem(place, type.typeName() + ": '" + name + "' is declared twice");
      }
    }
  }

  private void problem(Place place, String problem) {
    diagnostics.error(place.file(), place.line(), place.element(), problem);
  }
}
