package org.sitaf.core.beginning;

import java.util.Map;
import org.sitaf.core.description.Method;

/** The lines of a test model that is being written. */
final class ModelText {
  private final StringBuilder text = new StringBuilder();

  void line(int indent, String content) {
    text.append(" ".repeat(indent)).append(content).append('\n');
  }

  /** The inputs of a method, unless it has none. */
  void inputs(int indent, Method method, Map<String, Object> constants, boolean isNode) {
    ElementProposals inputs = ElementProposals.ofInputs(method, constants, isNode);
    if (!inputs.lines().isEmpty()) {
      line(indent, "<input_spec_list>");
      inputs.lines().forEach(l -> line(indent + 2, l));
      line(indent, "</input_spec_list>");
    }
  }

  void output(int indent, String name, String kind, String head) {
    line(indent, head);
    line(indent + 2, "<name>" + ModelProposal.Xml.text(name) + "</name>");
    line(indent + 2, "<type>" + kind + "</type>");
    line(indent, "</test_element>");
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
