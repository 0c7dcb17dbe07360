package org.sitaf.core.beginning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.ScalarType;

/**
 * What the names of an interface's methods tell about its states.
 *
 * @param switches pairs such as {@code Enable} and {@code Disable}
 * @param lifeCycle the methods of a life cycle by their role; empty unless there are at least three
 * @param properties pairs such as {@code SetSpeed} and {@code GetSpeed}
 */
record MethodRoles(
    List<Switch> switches, Map<Transition, Method> lifeCycle, List<Property> properties) {
  private static final int LEAST_TRANSITIONS = 3;

  /** Verbs of a pair, and the word for the state between them. */
  private record Pair(String on, String off, String state) {}

  private static final List<Pair> PAIRS =
      List.of(
          new Pair("enable", "disable", "enabled"),
          new Pair("start", "stop", "started"),
          new Pair("begin", "end", "started"),
          new Pair("open", "close", "open"),
          new Pair("connect", "disconnect", "connected"),
          new Pair("activate", "deactivate", "active"),
          new Pair("attach", "detach", "attached"),
          new Pair("lock", "unlock", "locked"),
          new Pair("arm", "disarm", "armed"),
          new Pair("engage", "disengage", "engaged"),
          new Pair("pause", "resume", "paused"),
          new Pair("grasp", "release", "holding"),
          new Pair("grip", "release", "holding"),
          new Pair("acquire", "release", "acquired"),
          new Pair("load", "unload", "loaded"),
          new Pair("mount", "unmount", "mounted"),
          new Pair("register", "unregister", "registered"),
          new Pair("subscribe", "unsubscribe", "subscribed"),
          new Pair("login", "logout", "logged_in"),
          new Pair("turn on", "turn off", "on"),
          new Pair("switch on", "switch off", "on"),
          new Pair("power on", "power off", "powered"),
          new Pair("initialize", "shutdown", "initialized"),
          new Pair("initialize", "finalize", "initialized"),
          new Pair("init", "shutdown", "initialized"));

  MethodRoles {
    switches = List.copyOf(switches);
    properties = List.copyOf(properties);
  }

  /** Two methods that switch a state on and off. */
  record Switch(String state, Method on, Method off) {}

  /** Two methods that set and get a value. */
  record Property(String name, DataType type, Method set, Method get) {}

  /** The transitions of a component's life cycle, as in OPRoS. */
  enum Transition {
    INITIALIZE("created", "ready", "initialize", "init", "configure"),
    START("ready", "active", "start", "activate"),
    STOP("active", "ready", "stop", "deactivate"),
    DESTROY("ready", "created", "destroy", "finalize", "cleanup", "terminate");

    private final String from;
    private final String to;
    private final List<String> verbs;

    Transition(String from, String to, String... verbs) {
      this.from = from;
      this.to = to;
      this.verbs = List.of(verbs);
    }

    String from() {
      return from;
    }

    String to() {
      return to;
    }
  }

  static MethodRoles of(InterfaceDescription provided) {
    Map<String, Method> byWords = new LinkedHashMap<>();
    for (Method method : provided.methods()) {
      if (provided.methodsNamed(method.name()).size() == 1) {
        byWords.putIfAbsent(String.join(" ", NumberRange.words(method.name())), method);
      }
    }
    Map<Transition, Method> lifeCycle = lifeCycle(byWords);
    List<Switch> switches = new ArrayList<>();
    for (Pair pair : PAIRS) {
      byWords.forEach(
          (words, method) ->
              rest(words, pair.on())
                  .filter(rest -> byWords.containsKey((pair.off() + " " + rest).strip()))
                  .map(rest -> switched(pair, rest, byWords))
                  .filter(s -> !lifeCycle.containsValue(s.on()))
                  .filter(s -> switches.stream().noneMatch(o -> o.off().equals(s.off())))
                  .filter(s -> switches.stream().noneMatch(o -> o.state().equals(s.state())))
                  .ifPresent(switches::add));
    }
    return new MethodRoles(switches, lifeCycle, properties(byWords));
  }

  boolean isEmpty() {
    return switches.isEmpty() && lifeCycle.isEmpty();
  }

  /** What follows a verb; empty if the words do not begin with it. */
  private static Optional<String> rest(String words, String verb) {
    return words.equals(verb) || words.startsWith(verb + " ")
        ? Optional.of(words.substring(verb.length()).strip())
        : Optional.empty();
  }

  private static Switch switched(Pair pair, String rest, Map<String, Method> byWords) {
    String state = rest.isEmpty() ? pair.state() : rest.replace(' ', '_') + "_" + pair.state();
    return new Switch(
        state,
        byWords.get((pair.on() + " " + rest).strip()),
        byWords.get((pair.off() + " " + rest).strip()));
  }

  private static Map<Transition, Method> lifeCycle(Map<String, Method> byWords) {
    Map<Transition, Method> found = new LinkedHashMap<>();
    for (Transition transition : Transition.values()) {
      for (String verb : transition.verbs) {
        for (String words : List.of(verb, "on " + verb)) {
          Method method = byWords.get(words);
          if (method != null && method.parameters().isEmpty()) {
            found.putIfAbsent(transition, method);
          }
        }
      }
    }
    boolean complete =
        found.size() >= LEAST_TRANSITIONS
            && found.containsKey(Transition.INITIALIZE)
            && found.containsKey(Transition.START);
    return complete ? found : Map.of();
  }

  private static List<Property> properties(Map<String, Method> byWords) {
    List<Property> found = new ArrayList<>();
    byWords.forEach(
        (words, set) -> {
          Optional<Method> get =
              rest(words, "set")
                  .filter(rest -> !rest.isEmpty())
                  .map(rest -> byWords.get("get " + rest));
          if (get.isPresent()
              && set.parameters().size() == 1
              && set.parameters().get(0).direction() == Direction.IN
              && get.get().parameters().isEmpty()
              && get.get().returnType().equals(set.parameters().get(0).type())) {
            found.add(
                new Property(
                    words.substring("set ".length()).replace(' ', '_'),
                    get.get().returnType(),
                    set,
                    get.get()));
          }
        });
    return found;
  }

  /** Whether a method asks for a state that a switch sets, such as {@code IsEnabled}. */
  static boolean asksFor(Method method, Switch asked) {
    return method.parameters().isEmpty()
        && method.returnType().equals(new DataType.Scalar(ScalarType.BOOLEAN))
        && List.of("is " + asked.state(), "is " + asked.state() + " now", asked.state())
            .contains(String.join(" ", NumberRange.words(method.name())).replace('_', ' '));
  }
}
