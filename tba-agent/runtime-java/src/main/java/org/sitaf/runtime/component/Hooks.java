package org.sitaf.runtime.component;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sitaf.runtime.CannotRunException;

/**
 * Calls the life-cycle methods and the periodic method of a component, which it finds by name,
 * including the names of OPRoS. A method of a provided interface is never a hook; the test calls
 * it.
 */
public final class Hooks {
  private static final List<String> INITIALISE =
      List.of("initialise", "initialize", "onInitialize");
  private static final List<String> START = List.of("start", "onStart");
  private static final List<String> STOP = List.of("stop", "onStop");
  private static final List<String> DESTROY = List.of("destroy", "onDestroy");
  private static final List<String> EXECUTE = List.of("onExecute", "execute");

  private final Set<String> notHooks;
  private final Map<List<String>, Optional<Method>> found = new HashMap<>();

  /** Excludes methods with these names. */
  public Hooks(String... notHooks) {
    this.notHooks = Set.of(notHooks);
  }

  /** Initialises and starts a component if it has the methods. */
  public void begin(Object component) throws Exception {
    call(component, INITIALISE);
    call(component, START);
  }

  /** Stops, destroys and closes a component if it has the methods. */
  public void end(Object component) throws Exception {
    try {
      call(component, STOP);
      call(component, DESTROY);
    } finally {
      if (component instanceof AutoCloseable closeable) {
        closeable.close();
      }
    }
  }

  /**
   * Executes one period.
   *
   * @throws CannotRunException when the component has no method for it
   */
  public void execute(Object component) throws Exception {
    if (!call(component, EXECUTE)) {
      throw new CannotRunException(
          component.getClass().getName()
              + " has no public method onExecute() or execute(), which activity.yaml's execution:"
              + " periodic asks for");
    }
  }

  private boolean call(Object component, List<String> names) throws Exception {
    Optional<Method> hook = found.computeIfAbsent(names, n -> find(component.getClass(), n));
    if (hook.isEmpty()) {
      return false;
    }
    try {
      hook.get().invoke(component);
      return true;
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw e.getCause() instanceof Exception exception ? exception : e;
    } catch (IllegalAccessException e) {
      throw new CannotRunException(
          component.getClass().getName()
              + " must be public, so that "
              + hook.get().getName()
              + "() can be called",
          e);
    }
  }

  private Optional<Method> find(Class<?> type, List<String> names) {
    return names.stream()
        .filter(name -> !notHooks.contains(name))
        .flatMap(
            name ->
                Arrays.stream(type.getMethods())
                    .filter(m -> m.getName().equals(name) && m.getParameterCount() == 0))
        .filter(m -> !Modifier.isStatic(m.getModifiers()) && !m.isBridge())
        .findFirst();
  }
}
