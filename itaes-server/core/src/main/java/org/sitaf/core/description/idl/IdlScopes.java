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
 * Resolves names by the rules of IDL: first in the scope where a name is used, then in the
 * inherited interfaces, then in each enclosing scope. A scope is the qualified name of a module or
 * interface, empty for the global scope.
 */
final class IdlScopes {
  private final Map<String, List<ScopedNameContext>> bases = new HashMap<>();
  private final Map<String, List<String>> resolvedBases = new HashMap<>();
  private final Set<String> interfaces = new LinkedHashSet<>();

  /** Typedefs of a name without dimensions, which may be that of an interface. */
  private final Map<String, Alias> aliases = new HashMap<>();

  private record Alias(ScopedNameContext of, String scope) {}

  /** Maximum number of direct and indirect base interfaces. */
  static final int MAX_LINEAGE = 100;

  /** Declares an interface. */
  void declareInterface(String qualified, List<ScopedNameContext> inherited) {
    interfaces.add(qualified);
    bases.put(qualified, inherited);
  }

  /** Declares another name of what may be an interface. */
  void declareAlias(String qualified, ScopedNameContext of, String scope) {
    aliases.putIfAbsent(qualified, new Alias(of, scope));
  }

  /** Whether an interface is declared. */
  boolean isInterface(String qualified) {
    return interfaces.contains(qualified);
  }

  /** The qualified name of a name in a scope. */
  static String inside(String scope, String name) {
    return scope.isEmpty() ? name : scope + "::" + name;
  }

  /** An identifier without the leading '_' that escapes keywords. */
  static String text(NameContext name) {
    String text = name.getText();
    return text.length() > 1 && text.startsWith("_") ? text.substring(1) : text;
  }

  /** A scoped name without the '_' that escapes keywords. */
  static String text(ScopedNameContext name) {
    List<String> parts = name.name().stream().map(IdlScopes::text).toList();
    return (name.getText().startsWith("::") ? "::" : "") + String.join("::", parts);
  }

  /** Resolves a name to a qualified name for which {@code exists} holds. */
  Optional<String> find(ScopedNameContext name, String scope, Predicate<String> exists) {
    return find(text(name), scope, exists);
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

  /** Resolves the name of a base interface. */
  Optional<String> base(ScopedNameContext name, String inheriting) {
    return find(text(name), enclosing(inheriting), q -> interfaceOf(q).isPresent())
        .flatMap(this::interfaceOf);
  }

  /** The interface of a qualified name, which may be that of a typedef. */
  private Optional<String> interfaceOf(String qualified) {
    Optional<String> name = Optional.of(qualified);
    for (int i = 0; i < MAX_LINEAGE && name.isPresent() && !isInterface(name.get()); i++) {
      Alias alias = aliases.get(name.get());
      name =
          alias == null
              ? Optional.empty()
              : find(alias.of(), alias.scope(), q -> isInterface(q) || aliases.containsKey(q));
    }
    return name.filter(this::isInterface);
  }

  /**
   * An interface after all its direct and indirect bases, without duplicates. With more than {@link
   * #MAX_LINEAGE} bases, the list is cut off before the interface itself.
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
      // The bases may be looked up in the interface itself, by a typedef of its body.
      resolvedBases.put(qualified, List.of());
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
