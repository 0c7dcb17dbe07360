package org.sitaf.core.harness.plan;

import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;

/** Method names that the runtimes call as life-cycle hooks of a component. */
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
   * The methods of the component's interfaces that have the name of a hook. The runtime must not
   * call them, because the test does.
   *
   * @param alternative alternative naming convention of the language
   */
  public static List<String> among(
      List<InterfaceDescription> provided, UnaryOperator<String> alternative) {
    Set<String> names = NAMES.stream().map(alternative).collect(Collectors.toSet());
    return provided.stream()
        .flatMap(i -> i.methods().stream())
        .map(Method::name)
        .filter(name -> NAMES.contains(name) || names.contains(alternative.apply(name)))
        .distinct()
        .toList();
  }
}
