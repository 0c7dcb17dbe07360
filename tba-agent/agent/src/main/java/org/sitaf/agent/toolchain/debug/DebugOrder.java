package org.sitaf.agent.toolchain.debug;

import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * The order to debug the first process of a test application.
 *
 * @param activity the user's folder of the activity, whose sources a debugger shows
 * @param className qualified class of the component, in the syntax of its language
 * @param methods names of the methods under test, which are the breakpoints
 * @param inTerminal whether {@link Debuggee#debugger} is used, and not an IDE
 * @param waiting receives the process after its start; must return at once
 */
public record DebugOrder(
    Path activity,
    String className,
    List<String> methods,
    boolean inTerminal,
    Consumer<Debuggee> waiting) {
  public DebugOrder {
    activity = activity.toAbsolutePath().normalize();
    Objects.requireNonNull(className);
    methods = List.copyOf(methods);
    Objects.requireNonNull(waiting);
  }
}
