package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Method;
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
    reach(source, method, method.returnType());
    method.parameters().forEach(p -> reach(source, method, p.type()));
  }

  List<DataType> inOrder() {
    return inOrder;
  }

  private void reach(String source, Method method, DataType type) {
    if (type instanceof DataType.Unknown) {
      problem(
          source, method, type.spelling() + " is a type that no document of the activity defines");
      return;
    }
    boolean declared = type instanceof DataType.Struct || type instanceof DataType.Enumeration;
    if (declared && byName.containsKey(type.spelling())) {
      if (!byName.get(type.spelling()).equals(type)) {
        problem(source, method, "two different types are named " + type.spelling());
      }
      return;
    }
    if (declared) {
      byName.put(type.spelling(), type);
      name(source, method, type);
      words(source, method, type);
    }
    type.parts().forEach(part -> reach(source, method, part));
    if (declared) {
      inOrder.add(type);
    }
  }

  /** Languages drop the scope of a name, so that what is left must be a word, and the only one. */
  private void name(String source, Method method, DataType type) {
    String simple = HarnessPlan.simpleName(type);
    if (!Words.isWord(simple)) {
      problem(source, method, "the type " + type.spelling() + " has no name that is an identifier");
    } else if (inScopes.putIfAbsent(simple, type) != null) {
      problem(
          source,
          method,
          type.spelling()
              + " and "
              + inScopes.get(simple).spelling()
              + " have the same name in a test");
    }
  }

  private void words(String source, Method method, DataType type) {
    List<String> names =
        type instanceof DataType.Struct struct
            ? struct.members().stream().map(DataType.Member::name).toList()
            : type instanceof DataType.Enumeration enumeration ? enumeration.literals() : List.of();
    Set<String> seen = new HashSet<>();
    for (String name : names) {
      if (!Words.isWord(name)) {
        problem(source, method, type.spelling() + ": '" + name + "' is not an identifier");
      } else if (!seen.add(name)) {
        problem(source, method, type.spelling() + ": '" + name + "' is declared twice");
      }
    }
  }

  private void problem(String source, Method method, String problem) {
    diagnostics.error(source, method.line(), "method " + method.name(), problem);
  }
}
