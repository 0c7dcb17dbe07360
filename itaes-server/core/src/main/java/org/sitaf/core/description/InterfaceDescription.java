package org.sitaf.core.description;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;

/**
 * An interface of a component (paper, Fig. 3).
 *
 * @param name the {@code type_name}
 * @param source name of the document it was read from
 * @param constants that the documents declare, by their name with dots, such as {@code
 *     Spin_Result.TIMEOUT}: Long, Double, Boolean or String
 */
public record InterfaceDescription(
    String name, List<Method> methods, String source, Map<String, Object> constants) {
  public InterfaceDescription {
    Objects.requireNonNull(name);
    Objects.requireNonNull(source);
    methods = List.copyOf(methods);
    constants = Map.copyOf(constants);
  }

  /** An interface without constants. */
  public InterfaceDescription(String name, List<Method> methods, String source) {
    this(name, methods, source, Map.of());
  }

  /** A copy with constants. */
  public InterfaceDescription withConstants(Map<String, Object> declared) {
    return new InterfaceDescription(name, methods, source, declared);
  }

  /** A copy with the methods that fit. */
  public InterfaceDescription withMethods(Predicate<Method> fit) {
    return new InterfaceDescription(name, methods.stream().filter(fit).toList(), source, constants);
  }

  /** All overloads of a method. */
  public List<Method> methodsNamed(String methodName) {
    return methods.stream().filter(m -> m.name().equals(methodName)).toList();
  }
}
