package org.sitaf.core.description.idl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.NameContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ScopedNameContext;

/**
 * Finds names as IDL does: in the scope where they are used, in the interfaces that it inherits
 * from, then in each scope around it. A scope is the qualified name of a module or interface, empty
 * for the outermost.
 */
final class IdlScopes {
  private final Map<String, List<ScopedNameContext>> bases = new HashMap<>();
  private final Map<String, List<String>> resolvedBases = new HashMap<>();
  private final Set<String> interfaces = new LinkedHashSet<>();

  /** Greatest number of interfaces that one inherits from, all levels together. */
  static final int MAX_LINEAGE = 100;

  /** Makes an interface known. */
  void declareInterface(String qualified, List<ScopedNameContext> inherited) {
    interfaces.add(qualified);
    bases.put(qualified, inherited);
  }

  /** Whether an interface of this qualified name is known. */
  boolean isInterface(String qualified) {
    return interfaces.contains(qualified);
  }

  /** A name within a scope. */
  static String inside(String scope, String name) {
    return scope.isEmpty() ? name : scope + "::" + name;
  }

  /** A name as it is meant: a leading '_' only tells it apart from a word of the language. */
  static String spelling(NameContext name) {
    String text = name.getText();
    return text.length() > 1 && text.startsWith("_") ? text.substring(1) : text;
  }

  /** A scoped name as it is meant. */
  static String spelling(ScopedNameContext name) {
    List<String> parts = name.name().stream().map(IdlScopes::spelling).toList();
    return (name.getText().startsWith("::") ? "::" : "") + String.join("::", parts);
  }

  /** The qualified name that a name means, among those that exist. */
  Optional<String> find(ScopedNameContext name, String scope, Predicate<String> exists) {
    return find(spelling(name), scope, exists);
  }

  private Optional<String> find(String name, String scope, Predicate<String> exists) {
    if (name.startsWith("::")) {
      return Optional.of(name.substring(2)).filter(exists);
    }
    for (String around = scope; ; around = enclosing(around)) {
      for (String candidate : withInherited(around)) {
        String qualified = inside(candidate, name);
        if (exists.test(qualified)) {
          return Optional.of(qualified);
        }
      }
      if (around.isEmpty()) {
        return Optional.empty();
      }
    }
  }

  /** The interface of a name that another inherits from. */
  Optional<String> base(ScopedNameContext name, String inheriting) {
    return find(spelling(name), enclosing(inheriting), interfaces::contains);
  }

  /**
   * An interface and all that it inherits from, bases first, each once; without the interface where
   * there are more than {@link #MAX_LINEAGE}.
   */
  List<String> lineage(String qualified) {
    Set<String> lineage = new LinkedHashSet<>();
    Set<String> entered = new LinkedHashSet<>();
    Deque<String> open = new ArrayDeque<>(List.of(qualified));
    while (!open.isEmpty() && entered.size() <= MAX_LINEAGE) {
      String next = open.peek();
      if (!entered.add(next)) {
        open.pop();
        lineage.add(next);
        continue;
      }
      List<String> inherited = new ArrayList<>(directBases(next));
      java.util.Collections.reverse(inherited);
      inherited.stream().filter(b -> !entered.contains(b)).forEach(open::push);
    }
    return List.copyOf(lineage);
  }

  private Set<String> withInherited(String scope) {
    Set<String> scopes = new LinkedHashSet<>();
    Deque<String> open = new ArrayDeque<>(List.of(scope));
    while (!open.isEmpty() && scopes.size() <= MAX_LINEAGE) {
      String next = open.poll();
      if (scopes.add(next)) {
        open.addAll(directBases(next));
      }
    }
    return scopes;
  }

  private List<String> directBases(String qualified) {
    List<String> known = resolvedBases.get(qualified);
    if (known == null) {
      known =
          bases.getOrDefault(qualified, List.of()).stream()
              .flatMap(name -> base(name, qualified).stream())
              .toList();
      resolvedBases.put(qualified, known);
    }
    return known;
  }

  private static String enclosing(String scope) {
    int end = scope.lastIndexOf("::");
    return end < 0 ? "" : scope.substring(0, end);
  }
}
