package org.sitaf.core.harness.ros;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ros.RosElements;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlanner;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceEvent;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.CaseParameter;

/** Plans the steps of a sequence of a ROS 2 node: its calls, and the events of its world. */
final class RosSteps {
  private static final double NANOS = 1e9;

  private final Activity activity;
  private final TestModel model;
  private final SequenceSpec sequence;
  private final Diagnostics diagnostics;

  private RosSteps(
      Activity activity, TestModel model, SequenceSpec sequence, Diagnostics diagnostics) {
    this.activity = activity;
    this.model = model;
    this.sequence = sequence;
    this.diagnostics = diagnostics;
  }

  static Map<String, Object> of(
      Activity activity, TestModel model, SequenceSpec sequence, Diagnostics diagnostics) {
    RosSteps steps = new RosSteps(activity, model, sequence, diagnostics);
    steps.refuseUnsupported();
    Map<String, Object> plan = new LinkedHashMap<>();
    plan.put("calls", sequence.calls().stream().map(steps::call).toList());
    plan.put("events", sequence.events().stream().map(steps::event).toList());
    return plan;
  }

  private void refuseUnsupported() {
    if (sequence.calls().isEmpty()) {
      problem(sequence.line(), "sequence_spec", "contains no call; a test needs at least one");
    }
    if (sequence.threads() > 1) {
      problem(
          sequence.line(),
          "sequence_spec",
          "threads=\""
              + sequence.threads()
              + "\" is not supported for ROS 2 nodes; remove the attribute");
    }
    if (model.timing() != null) {
      problem(sequence.line(), "sequence_spec", "repeated calls (timing) are not supported");
    }
    if (!model.relations().isEmpty()) {
      problem(sequence.line(), "sequence_spec", "relation_list is not supported in a sequence");
    }
    if (activity.profile().reference() != null) {
      diagnostics.error(
          HarnessPlanner.PROFILE, 0, "reference", "is not supported for a model with a sequence");
    }
    for (InputElement input : model.inputs()) {
      if (input.kind() == InputKind.TDI && !holdsFromStart(input)) {
        problem(
            input.line(),
            "test_element " + input.name(),
            "is no parameter of the node (parameter.NAME) and no line of its standard input; write"
                + " inputs of a call at the call");
      }
    }
  }

  /** Whether a TDI is set when the node begins, not by a call. */
  private boolean holdsFromStart(InputElement input) {
    return input.name().startsWith(RosElements.PARAMETER) || isLine(input);
  }

  private boolean isLine(InputElement input) {
    return Objects.requireNonNull(activity.ros()).node().stdin().contains(input.name());
  }

  private Map<String, Object> call(SequenceCall call) {
    TestModel called = call.model();
    if (call.overlap()) {
      problem(
          call.line(),
          "call " + call.name(),
          "overlap=\"true\" is not supported for ROS 2 nodes; remove the attribute");
    }
    List<Parameter> lines = Objects.requireNonNull(activity.ros()).lines();
    for (InputElement input : called.inputs()) {
      boolean isLine = lines.stream().anyMatch(l -> l.name().equals(MemberPath.root(input.name())));
      if (input.name().equals(RosElements.CALLBACK_ORDER)
          || input.name().startsWith(RosElements.PARAMETER)
          || isLine) {
        problem(
            call.line(),
            "call " + call.name(),
            "test_element "
                + input.name()
                + " holds from the start of the case; move it to the input_spec_list of the model");
      }
    }
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", call.name());
    entry.put("target", RosHarness.target(activity, called));
    entry.put("settle", called.target().settle().toNanos() / NANOS);
    entry.put("run_for", called.target().runFor().toNanos() / NANOS);
    List<CaseParameter> inputs =
        called.inputs().stream()
            .map(i -> new CaseParameter(i.name(), i.kind(), i.realType()))
            .toList();
    entry.put(
        "inputs",
        RosHarness.inputs(
            inputs.stream()
                .filter(i -> i.kind() == InputKind.TDI)
                .map(CaseParameter::name)
                .toList()));
    entry.put("settings", RosHarness.settings(inputs));
    entry.put("answers", RosHarness.answers(inputs));
    entry.put("outputs", RosHarness.outputs(called));
    return entry;
  }

  private Map<String, Object> event(SequenceEvent event) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", event.name());
    entry.put("set", event.set());
    double to = Double.NaN;
    if (event.to() instanceof Value.Real real) {
      to = real.number();
    }
    if (Double.isNaN(to)) {
      problem(
          event.line(), "event " + event.name(), "'" + event.to().literal() + "' is not a number");
    }
    entry.put("to", to);
    return entry;
  }

  private void problem(int line, String element, String text) {
    diagnostics.error(model.source(), line, element, text);
  }
}
