package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;

/**
 * The prototype of a method.
 *
 * @param raises names of the declared exceptions
 * @param line line in the document, from 1; 0 if unknown
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

  /** Creates a method without declared exceptions. */
  public Method(
      String name, DataType returnType, List<Parameter> parameters, CallType callType, int line) {
    this(name, returnType, parameters, callType, List.of(), line);
  }

  /** The parameter types, such as {@code int32,double}. Distinguishes overloads. */
  public String signature() {
    return parameters.stream().map(p -> p.type().typeName()).collect(Collectors.joining(","));
  }
}
