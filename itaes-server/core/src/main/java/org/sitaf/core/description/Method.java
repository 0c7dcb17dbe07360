package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;

/**
 * Prototype of a method.
 *
 * @param raises names of the exceptions that it declares
 * @param line where it stands in its document, from 1; 0 where that is unknown
 */
public record Method(
    String name,
    DataType returnType,
    List<Parameter> parameters,
    CallType callType,
    List<String> raises,
    int line) {
  public Method {
    Objects.requireNonNull(name);
    Objects.requireNonNull(returnType);
    Objects.requireNonNull(callType);
    parameters = List.copyOf(parameters);
    raises = List.copyOf(raises);
  }

  /** A method that declares no exception. */
  public Method(
      String name, DataType returnType, List<Parameter> parameters, CallType callType, int line) {
    this(name, returnType, parameters, callType, List.of(), line);
  }

  /** Types of the parameters, such as {@code int32,double}; tells overloads apart. */
  public String signature() {
    return parameters.stream().map(p -> p.type().spelling()).collect(Collectors.joining(","));
  }
}
