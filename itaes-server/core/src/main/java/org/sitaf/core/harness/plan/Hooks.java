package org.sitaf.core.harness.plan;

import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;

/** Names that runtimes take for steps in the life of a component. */
public final class Hooks {
  private static final Set<String> NAMES =
      Set.of(
          "initialise",
          "initialize",
          "onInitialize",
          "start",
          "onStart",
          "stop",
          "onStop",
          "destroy",
          "onDestroy",
          "close",
          "onExecute",
          "execute");

  private Hooks() {}

  /**
   * Methods of the component's interfaces that its life must not call, since the test does.
   *
   * @param spelling how else the language lets a component name its methods
   */
  public static List<String> among(
      List<InterfaceDescription> provided, UnaryOperator<String> spelling) {
    Set<String> spelled = NAMES.stream().map(spelling).collect(Collectors.toSet());
    return provided.stream()
        .flatMap(i -> i.methods().stream())
        .map(Method::name)
        .filter(name -> NAMES.contains(name) || spelled.contains(spelling.apply(name)))
        .distinct()
        .toList();
  }
}
