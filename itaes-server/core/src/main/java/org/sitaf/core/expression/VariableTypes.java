package org.sitaf.core.expression;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.expression.type.Type;

/**
 * The types of the variables of {@link Variables}: paths such as {@code pose.x} and {@code path[0]}
 * become members and elements.
 */
public final class VariableTypes {
  private final Map<String, Node> roots = new LinkedHashMap<>();

  /** A variable, or a part of one. Its own type hides those of its parts. */
  private static final class Node {
    private @Nullable Type type;
    private @Nullable Node element;
    private final Map<String, Node> members = new LinkedHashMap<>();

    Type type() {
      if (type != null) {
        return type;
      }
      if (element != null) {
        return new Type.Sequence(members.isEmpty() ? element.type() : Type.ANY);
      }
      Map<String, Type> types = new LinkedHashMap<>();
      members.forEach((name, node) -> types.put(name, node.type()));
      return new Type.Members("", types);
    }
  }

  /** Adds the type at a path. A name that is not a path has no variable. */
  public VariableTypes put(String name, Type type) {
    List<Object> path = Variables.path(name);
    if (path.isEmpty()) {
      return this;
    }
    Node node = roots.computeIfAbsent((String) path.get(0), n -> new Node());
    for (Object step : path.subList(1, path.size())) {
      if (step instanceof String member) {
        node = node.members.computeIfAbsent(member, m -> new Node());
      } else {
        node.element = node.element == null ? new Node() : node.element;
        node = node.element;
      }
    }
    Type joined = node.type == null ? type : Type.join(node.type, type);
    node.type = Objects.requireNonNullElse(joined, Type.ANY);
    return this;
  }

  /** The types by variable. */
  public Map<String, Type> map() {
    Map<String, Type> types = new LinkedHashMap<>();
    roots.forEach((name, node) -> types.put(name, node.type()));
    for (String name : roots.keySet()) {
      FaultName.find(name)
          .ifPresent(
              fault ->
                  Stream.of(FaultName.Part.AT.suffix(), FaultName.Part.FOR.suffix(), FaultName.END)
                      .forEach(part -> types.putIfAbsent(fault.fault() + part, Type.REAL)));
    }
    return types;
  }
}
