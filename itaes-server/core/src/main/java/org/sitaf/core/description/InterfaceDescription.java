package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;

/**
 * An interface of a component (paper, Fig. 3).
 *
 * @param name the {@code type_name}
 * @param source name of the document it was read from
 */
public record InterfaceDescription(String name, List<Method> methods, String source) {
  public InterfaceDescription {
    Objects.requireNonNull(name);
    Objects.requireNonNull(source);
    methods = List.copyOf(methods);
  }

  /** All overloads of a method. */
  public List<Method> methodsNamed(String methodName) {
    return methods.stream().filter(m -> m.name().equals(methodName)).toList();
  }
}
