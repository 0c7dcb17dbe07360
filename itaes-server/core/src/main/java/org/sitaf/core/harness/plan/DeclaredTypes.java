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

/** Collects the structs and enumerations that interfaces reach, each after those it is made of. */
final class DeclaredTypes {
  private final Diagnostics diagnostics;
  private final Map<String, DataType> byName = new HashMap<>();
  private final Map<String, DataType> inScopes = new HashMap<>();
  private final List<DataType> inOrder = new ArrayList<>();

  DeclaredTypes(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /** Adds what a method of a document reaches. */
  void reach(String source, Method method) {
    Place place = new Place(source, method.line(), "method " + method.name());
    reach(place, method.returnType());
    method.parameters().forEach(p -> reach(place, p.type()));
  }

  /** Adds what is sent through a data port. */
  void reach(String source, Port.Data port) {
    reach(new Place(source, 0, "data_port " + port.name()), port.type());
  }

  List<DataType> inOrder() {
    return inOrder;
  }

  private void reach(Place place, DataType type) {
    if (type instanceof DataType.Unknown) {
      problem(place, type.spelling() + " is a type that no document of the activity defines");
      return;
    }
    boolean declared = type instanceof DataType.Struct || type instanceof DataType.Enumeration;
    if (declared && byName.containsKey(type.spelling())) {
      if (!byName.get(type.spelling()).equals(type)) {
        problem(place, "two different types are named " + type.spelling());
      }
      return;
    }
    if (declared) {
      byName.put(type.spelling(), type);
      name(place, type);
      words(place, type);
    }
    type.parts().forEach(part -> reach(place, part));
    if (declared) {
      inOrder.add(type);
    }
  }

  /** Languages drop the scope of a name, so that what is left must be a word, and the only one. */
  private void name(Place place, DataType type) {
    String simple = HarnessPlan.simpleName(type);
    if (!Words.isWord(simple)) {
      problem(place, "the type " + type.spelling() + " has no name that is an identifier");
    } else if (inScopes.putIfAbsent(simple, type) != null) {
      problem(
          place,
          type.spelling()
              + " and "
              + inScopes.get(simple).spelling()
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
        problem(place, type.spelling() + ": '" + name + "' is not an identifier");
      } else if (!seen.add(name)) {
        problem(place, type.spelling() + ": '" + name + "' is declared twice");
      }
    }
  }

  private void problem(Place place, String problem) {
    diagnostics.error(place.file(), place.line(), place.element(), problem);
  }
}
