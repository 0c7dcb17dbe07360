package org.sitaf.core.beginning;

import java.util.List;
import java.util.Map;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;

/** The text of a test model for one method, with comments where a person must decide. */
public final class ModelProposal {
  /** More cases than this tell little before the ranges are checked. */
  private static final int MAX_CASES = 100;

  private final ModelText text = new ModelText();
  private final InterfaceDescription provided;
  private final Method method;
  private final boolean isNode;

  private ModelProposal(InterfaceDescription provided, Method method, boolean isNode) {
    this.provided = provided;
    this.method = method;
    this.isNode = isNode;
  }

  /** The model of a method; {@code name} is unique in the activity. */
  static String of(InterfaceDescription provided, Method method, String name) {
    return new ModelProposal(provided, method, false).write(name);
  }

  /** The model of a method of a ROS 2 node, whose out-parameters are its messages. */
  public static String ofNode(InterfaceDescription provided, Method method, String name) {
    return new ModelProposal(provided, method, true).write(name);
  }

  private String write(String name) {
    boolean overloaded = provided.methodsNamed(method.name()).size() > 1;
    line(0, "<test_model>");
    line(2, "<name>" + Xml.text(name) + "</name>");
    line(
        2,
        "<target interface="
            + Xml.attribute(provided.name())
            + " method="
            + Xml.attribute(method.name())
            + (overloaded ? " signature=" + Xml.attribute(method.signature()) : "")
            + (isNode ? " settle=\"0.5\" run_for=\"1.0\"" : "")
            + "/>");
    ElementProposals inputs = ElementProposals.ofInputs(method, provided.constants(), isNode);
    if (inputs.lines().isEmpty()) {
      line(2, "<input_spec_list/>");
    } else {
      line(
          2,
          "<!-- The ranges are guesses from names and types. Decide which values are valid. -->");
      line(2, "<input_spec_list>");
      inputs.lines().forEach(l -> line(4, l));
      line(2, "</input_spec_list>");
    }
    outputs();
    line(2, "<order_of_combinations>" + (inputs.count() < 2 ? 1 : 2) + "</order_of_combinations>");
    if (inputs.count() > 1) {
      line(2, "<max_cases>" + Math.max(MAX_CASES, inputs.cases()) + "</max_cases>");
    }
    line(0, "</test_model>");
    return text.toString();
  }

  private void outputs() {
    List<Parameter> out =
        method.parameters().stream().filter(p -> p.direction() != Direction.IN).toList();
    if (method.returnType().isVoid() && out.isEmpty()) {
      line(
          2,
          "<!-- The method returns nothing. Observe its effect in a world, or in a post-condition."
              + " -->");
      line(2, "<output_spec_list/>");
      return;
    }
    if (isNode) {
      line(2, "<!-- The last message of each topic since the call, and their number. -->");
    }
    line(2, "<!-- Without <expected> or a post-condition, a case passes when the call returns:");
    line(
        2,
        "     add what the component must return, such as <expected>2.0 * speed</expected>. -->");
    line(2, "<output_spec_list>");
    if (!method.returnType().isVoid()) {
      output("return", "RETURN", method.returnType());
    }
    for (Parameter parameter : out) {
      output(parameter.name(), "OUT", parameter.type());
      if (isNode) {
        output(parameter.name() + ".count", "OUT", new DataType.Scalar(ScalarType.INT32));
      }
    }
    line(2, "</output_spec_list>");
  }

  private void output(String name, String kind, DataType type) {
    text.output(4, name, kind, ElementProposals.head(type));
  }

  private void line(int indent, String content) {
    text.line(indent, content);
  }

  /** Escapes text for XML. */
  static final class Xml {
    private Xml() {}

    static String text(String value) {
      return value.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    static String attribute(String value) {
      return '"' + text(value).replace("\"", "&quot;") + '"';
    }

    /** Text in a comment, which cannot contain two hyphens. */
    static String comment(String value) {
      return value.replaceAll("-(?=-)|-$", "- ");
    }
  }

  /** The constants of an interface by the last part of their names. */
  static Map<String, Object> shortNames(Map<String, Object> constants) {
    Map<String, Object> shortened = new java.util.TreeMap<>();
    constants.forEach(
        (name, value) -> shortened.put(name.substring(name.lastIndexOf('.') + 1), value));
    return shortened;
  }
}
