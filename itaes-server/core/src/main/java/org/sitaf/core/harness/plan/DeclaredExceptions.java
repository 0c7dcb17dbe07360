package org.sitaf.core.harness.plan;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.Diagnostics;

/** Removes the scopes of declared exceptions: {@code hw::NoEcho} becomes {@code NoEcho}. */
final class DeclaredExceptions {
  private final Diagnostics diagnostics;
  private final Map<String, String> scopedBySimple = new TreeMap<>();

  DeclaredExceptions(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /**
   * Returns the interfaces with simple exception names. Different exceptions with the same simple
   * name are reported.
   */
  List<InterfaceDescription> withSimpleNames(List<InterfaceDescription> interfaces) {
    return interfaces.stream()
        .map(
            i ->
                new InterfaceDescription(
                    i.name(),
                    i.methods().stream().map(m -> withSimpleNames(i.source(), m)).toList(),
                    i.source()))
        .toList();
  }

  /** The simple names of all exceptions so far. */
  Set<String> names() {
    return scopedBySimple.keySet();
  }

  private Method withSimpleNames(String source, Method method) {
    return new Method(
        method.name(),
        method.returnType(),
        method.parameters(),
        method.callType(),
        method.raises().stream().map(e -> simple(source, method, e)).distinct().toList(),
        method.line());
  }

  private String simple(String source, Method method, String exception) {
    String simple = HarnessPlan.simpleName(exception);
    String other = scopedBySimple.putIfAbsent(simple, exception);
    if (other != null && !other.equals(exception)) {
      diagnostics.error(
          source,
          method.line(),
          "method " + method.name(),
          "the exceptions " + other + " and " + exception + " have the same name in a test");
    }
    return simple;
  }
}
