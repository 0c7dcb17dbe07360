package org.sitaf.core.activity;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;

/**
 * The constants and enumeration literals of interfaces by name. Each has its full name, such as
 * {@code Mission.Mode.FAST}, and each shorter one, such as {@code Mode.FAST} and {@code FAST}, if
 * no other constant has it.
 */
final class InterfaceConstants {
  private final Map<String, Object> full = new TreeMap<>();
  private final Set<DataType> seen = new HashSet<>();

  private InterfaceConstants() {}

  static Map<String, Object> of(
      Collection<InterfaceDescription> provided, Collection<InterfaceDescription> required) {
    InterfaceConstants constants = new InterfaceConstants();
    provided.forEach(constants::add);
    required.forEach(constants::add);
    return constants.withShortNames();
  }

  private void add(InterfaceDescription description) {
    full.putAll(description.constants());
    for (Method method : description.methods()) {
      add(method.returnType());
      method.parameters().forEach(p -> add(p.type()));
    }
  }

  private void add(DataType type) {
    if (!seen.add(type)) {
      return;
    }
    if (type instanceof DataType.Enumeration enumeration) {
      String name = enumeration.name().replace("::", ".").replace('/', '.');
      // A literal is written as its name in documents.
      enumeration.literals().forEach(literal -> full.put(name + "." + literal, literal));
    }
    type.parts().forEach(this::add);
  }

  private Map<String, Object> withShortNames() {
    Map<String, Object> named = new TreeMap<>(full);
    Map<String, Integer> count = new HashMap<>();
    full.keySet().forEach(n -> shorter(n).forEach(s -> count.merge(s, 1, Integer::sum)));
    full.forEach(
        (name, value) ->
            shorter(name).stream()
                .filter(s -> count.get(s) == 1)
                .forEach(s -> named.putIfAbsent(s, value)));
    return named;
  }

  private static List<String> shorter(String name) {
    List<String> names = new java.util.ArrayList<>();
    for (int dot = name.indexOf('.'); dot >= 0; dot = name.indexOf('.', dot + 1)) {
      names.add(name.substring(dot + 1));
    }
    return names;
  }
}
