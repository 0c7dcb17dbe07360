package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.TreeMap;
import java.util.TreeSet;

/** The imports of a module in the order of isort: first the standard library. */
final class Imports {
  private static final List<String> STANDARD =
      List.of("abc", "collections.abc", "dataclasses", "enum", "typing");

  private final TreeMap<String, TreeSet<String>> standard = new TreeMap<>();
  private final TreeMap<String, TreeSet<String>> others = new TreeMap<>();

  /** Imports a name from a module. */
  Imports add(String module, String name) {
    (STANDARD.contains(module) ? standard : others)
        .computeIfAbsent(
            module,
            m ->
                // Constants, then classes, then functions.
                new TreeSet<>(
                    Comparator.comparing(Imports::rank).thenComparing(Comparator.naturalOrder())))
        .add(name);
    return this;
  }

  private static int rank(String name) {
    if (name.length() > 1 && name.equals(name.toUpperCase(java.util.Locale.ROOT))) {
      return 0;
    }
    return Character.isUpperCase(name.charAt(0)) ? 1 : 2;
  }

  /** The lines, with an empty line after those of the standard library. */
  String text() {
    List<String> blocks = new ArrayList<>();
    for (TreeMap<String, TreeSet<String>> block : List.of(standard, others)) {
      if (!block.isEmpty()) {
        StringBuilder lines = new StringBuilder();
        block.forEach((module, names) -> lines.append(line(module, names)).append('\n'));
        blocks.add(lines.toString());
      }
    }
    return String.join("\n", blocks).stripTrailing();
  }

  boolean isEmpty() {
    return standard.isEmpty() && others.isEmpty();
  }

  /** The {@code __all__} of a module that exports all its imports. */
  String all() {
    TreeSet<String> names = new TreeSet<>();
    others.values().forEach(names::addAll);
    return PythonText.list("__all__ = [", names.stream().map(PythonText::string).toList(), "]");
  }

  private static String line(String module, TreeSet<String> names) {
    return "from " + module + " import " + String.join(", ", names);
  }
}
