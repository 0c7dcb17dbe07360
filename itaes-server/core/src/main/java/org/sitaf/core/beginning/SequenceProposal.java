package org.sitaf.core.beginning;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sitaf.core.beginning.MethodRoles.Property;
import org.sitaf.core.beginning.MethodRoles.Switch;
import org.sitaf.core.beginning.MethodRoles.Transition;
import org.sitaf.core.beginning.ModelProposal.Xml;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;

/**
 * The text of a test model over sequences of calls, for an interface whose names tell states. It
 * states only what holds for a component that does nothing; comments say what a person can add.
 */
public final class SequenceProposal {
  private static final int MAX_CALLS = 12;
  private static final int SHORT = 6;
  private static final int LONG = 8;
  private static final String LIFE_CYCLE = "life_cycle";

  private final ModelText text = new ModelText();
  private final InterfaceDescription provided;
  private final MethodRoles roles;
  private final List<Method> calls;
  private final Set<String> parameters = new HashSet<>();

  private SequenceProposal(InterfaceDescription provided, MethodRoles roles) {
    this.provided = provided;
    this.roles = roles;
    this.calls = calls();
    calls.forEach(c -> c.parameters().forEach(p -> parameters.add(p.name())));
  }

  /** The model of an interface; empty if its names tell no states. */
  static Optional<String> of(InterfaceDescription provided, String name) {
    MethodRoles roles = MethodRoles.of(provided);
    return roles.isEmpty()
        ? Optional.empty()
        : Optional.of(new SequenceProposal(provided, roles).write(name));
  }

  /** The model of an interface; a model without states if its names tell none. */
  public static String always(InterfaceDescription provided, String name) {
    return new SequenceProposal(provided, MethodRoles.of(provided)).write(name);
  }

  /** The methods that change states first, then others that are not overloaded. */
  private List<Method> calls() {
    List<Method> chosen = new ArrayList<>(roles.lifeCycle().values());
    roles.switches().forEach(s -> chosen.addAll(List.of(s.on(), s.off())));
    provided.methods().stream()
        .filter(m -> provided.methodsNamed(m.name()).size() == 1)
        .filter(m -> !chosen.contains(m))
        .limit(Math.max(0, MAX_CALLS - chosen.size()))
        .forEach(chosen::add);
    return chosen;
  }

  private String write(String name) {
    line(0, "<test_model>");
    line(2, "<name>" + Xml.text(name) + "</name>");
    line(2, "<target interface=" + Xml.attribute(provided.name()) + "/>");
    line(2, "<input_spec_list/>");
    if (roles.isEmpty()) {
      line(2, "<!-- The names of the methods tell no states. Decide what the component");
    } else {
      line(
          2,
          "<!-- The states are guesses from the names of the methods. Decide what the component");
    }
    line(2, "     must remember, and which calls are allowed in which state. -->");
    int length = calls.size() > SHORT ? LONG : SHORT;
    line(2, "<sequence_spec length=\"" + length + "\" order=\"2\">");
    if (!roles.lifeCycle().isEmpty()) {
      line(
          4,
          "<state name="
              + Xml.attribute(state(LIFE_CYCLE))
              + " type=\"string\" initial=\""
              + Transition.INITIALIZE.from()
              + "\"/>");
    }
    for (Switch each : roles.switches()) {
      line(
          4,
          "<state name="
              + Xml.attribute(state(each.state()))
              + " type=\"boolean\" initial=\"false\"/>");
    }
    calls.forEach(this::call);
    line(2, "</sequence_spec>");
    roles.properties().forEach(this::advice);
    line(2, "<order_of_combinations>1</order_of_combinations>");
    line(0, "</test_model>");
    return text.toString();
  }

  private void call(Method method) {
    line(4, "<call name=" + Xml.attribute(method.name()) + ">");
    guard(method);
    text.inputs(6, method, provided.constants(), false);
    outputs(method);
    line(4, "</call>");
  }

  private void guard(Method method) {
    for (Map.Entry<Transition, Method> entry : roles.lifeCycle().entrySet()) {
      if (entry.getValue().equals(method)) {
        String state = state(LIFE_CYCLE);
        line(6, "<guard>" + state + " == \"" + entry.getKey().from() + "\"</guard>");
        update(state, "\"" + entry.getKey().to() + "\"");
        return;
      }
    }
    for (Switch each : roles.switches()) {
      String state = state(each.state());
      if (each.on().equals(method)) {
        update(state, "true");
        return;
      }
      if (each.off().equals(method)) {
        if (!guardsOthers(each)) {
          guess(state);
        }
        update(state, "false");
        return;
      }
    }
    if (roles.switches().size() == 1
        && roles.lifeCycle().isEmpty()
        && !MethodRoles.asksFor(method, roles.switches().get(0))) {
      guess(state(roles.switches().get(0).state()));
    } else if (roles.switches().isEmpty() && !roles.lifeCycle().isEmpty()) {
      guess(state(LIFE_CYCLE) + " == \"" + Transition.START.to() + "\"");
    }
  }

  /** Whether the state of the only switch decides about the calls of other methods. */
  private boolean guardsOthers(Switch only) {
    return roles.switches().size() == 1
        && roles.lifeCycle().isEmpty()
        && calls.stream()
            .filter(c -> !c.equals(only.on()) && !c.equals(only.off()))
            .anyMatch(c -> !MethodRoles.asksFor(c, only));
  }

  private void guess(String guard) {
    line(6, "<!-- A guess. Remove it if the call is always allowed. To test the call where it is");
    line(6, "     not, add what it does there: <forbidden>!error</forbidden> -->");
    line(6, "<guard>" + guard + "</guard>");
  }

  private void update(String state, String value) {
    line(6, "<update state=" + Xml.attribute(state) + ">" + value + "</update>");
  }

  private void outputs(Method method) {
    List<Parameter> out =
        method.parameters().stream().filter(p -> p.direction() != Direction.IN).toList();
    if (method.returnType().isVoid() && out.isEmpty()) {
      return;
    }
    roles.switches().stream()
        .filter(s -> MethodRoles.asksFor(method, s))
        .findFirst()
        .ifPresent(
            s ->
                line(
                    6,
                    "<!-- Add to the output: <expected>" + state(s.state()) + "</expected> -->"));
    line(6, "<output_spec_list>");
    if (!method.returnType().isVoid()) {
      text.output(8, "return", "RETURN", ElementProposals.head(method.returnType()));
    }
    out.forEach(p -> text.output(8, p.name(), "OUT", ElementProposals.head(p.type())));
    line(6, "</output_spec_list>");
  }

  /** How a value that is set and got becomes a state, which a component that does nothing lacks. */
  private void advice(Property property) {
    if (!calls.contains(property.set()) || !calls.contains(property.get())) {
      return;
    }
    String state = state(property.name());
    line(
        2,
        "<!-- If "
            + property.get().name()
            + " returns what "
            + property.set().name()
            + " has set, add a state and an expected value:");
    line(
        2,
        "     <state name=\"%s\" type=\"%s\" initial=\"%s\"/>"
            .formatted(
                state, property.type().typeName(), Xml.comment(Literals.zero(property.type()))));
    line(
        2,
        "     <update state=\"%s\">%s</update> in %s, <expected>%s</expected> in %s. -->"
            .formatted(
                state,
                property.set().parameters().get(0).name(),
                property.set().name(),
                state,
                property.get().name()));
  }

  /** A state may not have the name of an input. */
  private String state(String wanted) {
    return parameters.contains(wanted) ? "is_" + wanted : wanted;
  }

  private void line(int indent, String content) {
    text.line(indent, content);
  }
}
