package org.sitaf.core.harness;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;

/** A position of a name in an interface, and interfaces with given names at that position. */
enum NamePosition {
  PARAMETER,
  STUB,
  STUB_METHOD,
  STUB_PARAMETER,
  STRUCT,
  MEMBER,
  ENUMERATION,
  LITERAL,
  EXCEPTION;

  private static final DataType STRING = new DataType.Scalar(ScalarType.STRING);
  private static final DataType DOUBLE = new DataType.Scalar(ScalarType.DOUBLE);
  private static final DataType INT = new DataType.Scalar(ScalarType.INT32);
  private static final DataType VOID = new DataType.Scalar(ScalarType.VOID);

  /** The first method of the first interface is the method under test. */
  List<InterfaceDescription> provided(List<String> names) {
    List<Parameter> parameters =
        this == PARAMETER
            ? names.stream().map(n -> new Parameter(n, STRING, Direction.IN)).toList()
            : List.of(new Parameter("text", STRING, Direction.IN));
    Method say = new Method("Say", STRING, parameters, CallType.BLOCKING, 1);
    return List.of(new InterfaceDescription("EchoService", List.of(say), "provided.xml"));
  }

  List<InterfaceDescription> required(List<String> names) {
    return switch (this) {
      case PARAMETER -> List.of();
      case STUB -> names.stream().map(n -> required(n, List.of(method("Ask", INT)))).toList();
      case STUB_METHOD -> List.of(neighbour(names, n -> method(n, INT)));
      case STUB_PARAMETER ->
          List.of(
              required(
                  "Neighbour",
                  chunks(names).entrySet().stream()
                      .flatMap(
                          c ->
                              Stream.of(
                                  method("In" + c.getKey(), INT, c.getValue(), Direction.IN),
                                  method("Out" + c.getKey(), VOID, c.getValue(), Direction.OUT),
                                  method(
                                      "Both" + c.getKey(), DOUBLE, c.getValue(), Direction.INOUT)))
                      .toList()));
      case STRUCT ->
          List.of(
              numbered(
                  names, n -> new DataType.Struct(n, List.of(new DataType.Member("x", DOUBLE)))));
      case ENUMERATION ->
          List.of(numbered(names, n -> new DataType.Enumeration(n, List.of("ONE", "TWO"))));
      case MEMBER ->
          List.of(
              numbered(
                  chunks(names).keySet().stream().map(i -> "Shape" + i).toList(),
                  shape ->
                      new DataType.Struct(
                          shape,
                          chunks(names).get(Integer.parseInt(shape.substring(5))).stream()
                              .map(n -> new DataType.Member(n, DOUBLE))
                              .toList())));
      case LITERAL -> List.of(numbered(List.of("Mode"), m -> new DataType.Enumeration(m, names)));
      case EXCEPTION ->
          List.of(
              required(
                  "Neighbour",
                  List.of(new Method("Ask", INT, List.of(), CallType.BLOCKING, names, 1))));
    };
  }

  private static InterfaceDescription required(String name, List<Method> methods) {
    return new InterfaceDescription(name, methods, "required.xml");
  }

  private static InterfaceDescription neighbour(
      List<String> names, Function<String, Method> method) {
    return required("Neighbour", names.stream().map(method).toList());
  }

  /** A Java method has at most 255 parameters, and a double counts as two. */
  private static Map<Integer, List<String>> chunks(List<String> names) {
    Map<Integer, List<String>> chunks = new TreeMap<>();
    for (int i = 0; i < names.size(); i++) {
      chunks.computeIfAbsent(i / 100, n -> new ArrayList<>()).add(names.get(i));
    }
    return chunks;
  }

  /** For each type, a method with a parameter and a return value of the type. */
  private static InterfaceDescription numbered(
      List<String> names, Function<String, DataType> type) {
    List<Method> methods = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      DataType made = type.apply(names.get(i));
      methods.add(
          new Method(
              "Ask" + i,
              made,
              List.of(
                  new Parameter("given", made, Direction.IN),
                  new Parameter("taken", made, Direction.OUT)),
              CallType.BLOCKING,
              1));
    }
    return required("Neighbour", methods);
  }

  private static Method method(String name, DataType returns) {
    return new Method(name, returns, List.of(), CallType.BLOCKING, 1);
  }

  private static Method method(
      String name, DataType returns, List<String> parameters, Direction direction) {
    return new Method(
        name,
        returns,
        parameters.stream().map(p -> new Parameter(p, DOUBLE, direction)).toList(),
        CallType.BLOCKING,
        1);
  }
}
