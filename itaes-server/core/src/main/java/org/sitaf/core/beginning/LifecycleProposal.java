package org.sitaf.core.beginning;

import java.util.List;
import java.util.Map;
import org.sitaf.core.beginning.ModelProposal.Xml;
import org.sitaf.core.description.Method;

/**
 * The text of a test model over sequences for a lifecycle node of ROS 2: its transitions in any
 * order, and its input topics in each state.
 */
public final class LifecycleProposal {
  private static final int MAX_TOPICS = 8;

  /** A transition of {@code lifecycle_msgs/msg/Transition} between primary states. */
  private record Transition(String name, int id, int from, int to) {}

  private static final List<Transition> TRANSITIONS =
      List.of(
          new Transition("Configure", 1, 1, 2),
          new Transition("Activate", 3, 2, 3),
          new Transition("Deactivate", 4, 3, 2),
          new Transition("Cleanup", 2, 2, 1));

  private final ModelText text = new ModelText();

  private LifecycleProposal() {}

  /**
   * The model of a node that provides {@code ChangeState} and {@code GetState}.
   *
   * @param inputs methods that publish one input topic each
   */
  public static String of(String name, List<Method> inputs) {
    return new LifecycleProposal().write(name, inputs);
  }

  private String write(String name, List<Method> inputs) {
    line(0, "<test_model>");
    line(2, "<name>" + Xml.text(name) + "</name>");
    line(2, "<target/>");
    line(2, "<input_spec_list/>");
    line(2, "<!-- Transitions fail where the state does not allow them. Add what the node does in");
    line(2, "     each state, such as <expected>0</expected> of the count of an output. -->");
    line(2, "<sequence_spec length=\"6\" order=\"2\">");
    line(4, "<!-- As in lifecycle_msgs/msg/State: 1 unconfigured, 2 inactive, 3 active. -->");
    line(4, "<state name=\"state\" type=\"int\" initial=\"1\"/>");
    TRANSITIONS.forEach(this::transition);
    line(4, "<call name=\"State\" method=\"GetState\">");
    line(6, "<output_spec_list>");
    line(8, "<test_element abstract_type=\"NUMERIC\" real_type=\"int\">");
    line(10, "<name>return.id</name>");
    line(10, "<type>RETURN</type>");
    line(10, "<!-- If every transition succeeds: <expected>state</expected> -->");
    line(8, "</test_element>");
    line(6, "</output_spec_list>");
    line(4, "</call>");
    inputs.stream().limit(MAX_TOPICS).forEach(this::topic);
    line(2, "</sequence_spec>");
    line(2, "<order_of_combinations>1</order_of_combinations>");
    line(0, "</test_model>");
    return text.toString();
  }

  private void transition(Transition transition) {
    line(4, "<call name=\"" + transition.name() + "\" method=\"ChangeState\">");
    line(6, "<guard>state == " + transition.from() + "</guard>");
    line(6, "<forbidden>false</forbidden>");
    line(6, "<update state=\"state\">" + transition.to() + "</update>");
    line(6, "<input_spec_list>");
    line(8, "<test_element abstract_type=\"NUMERIC\" real_type=\"int\">");
    line(10, "<name>transition.id</name>");
    line(10, "<type>TDI</type>");
    line(10, "<user_value_list><value>" + transition.id() + "</value></user_value_list>");
    line(8, "</test_element>");
    line(6, "</input_spec_list>");
    line(6, "<output_spec_list>");
    line(8, "<test_element abstract_type=\"BOOLEAN\" real_type=\"boolean\">");
    line(10, "<name>return</name>");
    line(10, "<type>RETURN</type>");
    line(10, "<!-- If the transition always succeeds: <expected>true</expected> -->");
    line(8, "</test_element>");
    line(6, "</output_spec_list>");
    line(4, "</call>");
  }

  private void topic(Method method) {
    line(4, "<call name=" + Xml.attribute(method.name()) + " run_for=\"0.1\">");
    text.inputs(6, method, Map.of(), true);
    line(4, "</call>");
  }

  private void line(int indent, String content) {
    text.line(indent, content);
  }
}
