package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.expression.Variables;

/**
 * Converts the calls of the test stub to the variable of post-conditions: {@code
 * calls["Interface.Method"]}.
 */
final class CallRecord {
  /** Key of the list of the names of all called methods, in the order of the calls. */
  private static final String IN_ORDER = "";

  private static final String MESSAGES = RosNode.INTERFACE + ".";

  private final Map<String, List<Method>> methods = new LinkedHashMap<>();

  CallRecord(List<InterfaceDescription> required) {
    for (InterfaceDescription description : required) {
      for (Method method : description.methods()) {
        methods
            .computeIfAbsent(description.name() + "." + method.name(), n -> new ArrayList<>())
            .add(method);
      }
    }
  }

  /** Lists of calls by method. Every required method is a key, even if it was not called. */
  Map<String, Object> of(StubCalls calls) {
    List<Object> order = new ArrayList<>();
    Map<String, List<Object>> byMethod = new LinkedHashMap<>();
    methods.keySet().forEach(name -> byMethod.put(name, new ArrayList<>()));
    for (StubCalls.Call call : calls.recorded()) {
      order.add(call.method());
      byMethod.computeIfAbsent(call.method(), n -> new ArrayList<>()).add(arguments(call));
    }
    Map<String, Object> record = new LinkedHashMap<>(byMethod);
    record.put(IN_ORDER, order);
    return record;
  }

  /**
   * The calls of the interface {@code topics}, which are the messages of a ROS 2 node by output.
   */
  Map<String, Object> messages(StubCalls calls) {
    Map<String, Object> messages = new LinkedHashMap<>();
    of(calls)
        .forEach(
            (method, made) -> {
              if (method.startsWith(MESSAGES)) {
                messages.put(method.substring(MESSAGES.length()), made);
              }
            });
    return messages;
  }

  private Map<String, Object> arguments(StubCalls.Call call) {
    Map<String, Object> arguments = new LinkedHashMap<>();
    for (NamedValue argument : call.arguments()) {
      arguments.put(
          argument.output(), Variables.plain(argument.literal(), type(call, argument.output())));
    }
    return arguments;
  }

  /**
   * An overload is identified by its arguments. If they are ambiguous, the type is derived from the
   * literal.
   */
  private DataType type(StubCalls.Call call, String argument) {
    List<DataType> types =
        methods.getOrDefault(call.method(), List.of()).stream()
            .flatMap(m -> m.parameters().stream())
            .filter(p -> p.name().equals(argument))
            .map(Parameter::type)
            .distinct()
            .toList();
    return types.size() == 1 ? types.get(0) : new DataType.Unknown(argument);
  }
}
