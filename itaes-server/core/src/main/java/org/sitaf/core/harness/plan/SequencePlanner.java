package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.activity.TargetMethod;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan.CallStep;
import org.sitaf.core.harness.plan.HarnessPlan.EventStep;
import org.sitaf.core.harness.plan.HarnessPlan.Given;
import org.sitaf.core.harness.plan.HarnessPlan.Sequence;
import org.sitaf.core.harness.plan.HarnessPlan.Stub;
import org.sitaf.core.harness.plan.HarnessPlan.World;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceEvent;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;

/** Plans the steps of a sequence. Each call is planned as the call of a plain model is. */
final class SequencePlanner {
  private final Activity activity;
  private final TestModel model;
  private final SequenceSpec steps;
  private final TestSuite suite;
  private final List<InterfaceDescription> required;
  private final Diagnostics diagnostics;

  /** The names of errors in answers. */
  private final SortedSet<String> errors = new TreeSet<>();

  /**
   * @param required the required interfaces, with simple names of exceptions
   */
  SequencePlanner(
      Activity activity,
      TestModel model,
      SequenceSpec steps,
      TestSuite suite,
      List<InterfaceDescription> required,
      Diagnostics diagnostics) {
    this.activity = activity;
    this.required = required;
    this.model = model;
    this.steps = steps;
    this.suite = suite;
    this.diagnostics = diagnostics;
  }

  /**
   * Adds the steps to the plan of everything else.
   *
   * @param targets methods of the calls, in their order
   */
  HarnessPlan plan(HarnessPlan whole, List<TargetMethod> targets) {
    refuseUnsupported();
    List<CallStep> calls = new ArrayList<>();
    for (int i = 0; i < targets.size(); i++) {
      calls.add(call(whole, steps.calls().get(i), targets.get(i)));
    }
    List<EventStep> events = steps.events().stream().map(this::event).toList();
    return with(whole, new Sequence(calls, events, properties(), steps.threads()));
  }

  private void refuseUnsupported() {
    refuseThreads();
    if (model.timing() != null) {
      problem(steps.line(), "sequence_spec", "repeated calls (timing) are not supported");
    }
    if (!model.relations().isEmpty()) {
      problem(steps.line(), "sequence_spec", "relation_list is not supported in a sequence");
    }
  }

  /** Nodes of ROS 2 have one thread of callbacks, which the harness schedules itself. */
  private void refuseThreads() {
    if (activity.profile().ros() == null) {
      return;
    }
    if (steps.threads() > 1) {
      problem(
          steps.line(),
          "sequence_spec",
          "threads=\"" + steps.threads() + "\" is not supported for nodes of ROS 2; remove it");
    }
    for (SequenceCall call : steps.calls()) {
      if (call.overlap()) {
        problem(
            call.line(),
            "call " + call.name(),
            "overlap=\"true\" is not supported for nodes of ROS 2; remove it");
      }
    }
  }

  private CallStep call(HarnessPlan whole, SequenceCall call, TargetMethod target) {
    TestModel called = call.model();
    TestSuite values = valuesOf(call);
    Diagnostics own = new Diagnostics();
    World world = new HarnessPlanner(activity, called, values, own).world();
    List<Stub> stubs = List.of();
    if (called.inputs().stream().anyMatch(i -> i.kind() == InputKind.TDTS)) {
      StubPlanner planner = new StubPlanner(required, called, values, own);
      stubs = planner.plan();
      errors.addAll(planner.errors());
    }
    HarnessPlan plan =
        new HarnessPlan(
            whole.modelName(),
            whole.description(),
            target.declaring().name(),
            target.method(),
            whole.component(),
            new ArgumentPlanner(target, called, values, own).plan(),
            new OutputPlanner(target.method(), called, activity, own).plan(),
            world,
            stubs,
            List.of(),
            whole.provided(),
            whole.types(),
            whole.errors(),
            whole.limits(),
            List.of(),
            null);
    String where = "call " + call.name();
    diagnostics.addAll(own.all().stream().map(d -> d.orAt(call.line(), where)).toList());
    return new CallStep(call.name(), plan, call.overlap());
  }

  /** The values of a call in all cases, as a suite of single calls. */
  private TestSuite valuesOf(SequenceCall call) {
    List<TestCase> used = new ArrayList<>();
    for (TestCase testCase : suite.cases()) {
      for (TestStep step : testCase.steps()) {
        if (step.name().equals(call.name())) {
          used.add(new TestCase(used.size() + 1, step.valid(), step.values(), List.of()));
        }
      }
    }
    return new TestSuite(
        suite.name(),
        "",
        suite.modelName(),
        suite.generation(),
        call.model().inputs().stream()
            .map(i -> new CaseParameter(i.name(), i.kind(), i.realType()))
            .toList(),
        used);
  }

  private EventStep event(SequenceEvent event) {
    WorldDescription world = activity.world();
    double value = number(event);
    if (world == null) {
      problem(
          event.line(),
          "event " + event.name(),
          "sets " + event.set() + ", but activity.yaml has no world");
    } else if (!event.isFault()) {
      world
          .parameter(event.set())
          .ifPresentOrElse(
              p -> {
                if (value < p.min() || value > p.max()) {
                  problem(
                      event.line(),
                      "event " + event.name(),
                      "sets "
                          + event.set()
                          + " to "
                          + value
                          + ", which is outside its range from "
                          + p.min()
                          + " to "
                          + p.max());
                }
              },
              () ->
                  problem(
                      event.line(),
                      "event " + event.name(),
                      world.path() + " has no parameter " + event.set()));
    }
    return new EventStep(event.name(), event.set(), value);
  }

  /** The value of an event as a number; true is 1. */
  private double number(SequenceEvent event) {
    String literal = event.to().literal().strip();
    if (literal.equals("true") || literal.equals("false")) {
      return literal.equals("true") ? 1 : 0;
    }
    try {
      return Double.parseDouble(literal);
    } catch (NumberFormatException e) {
      problem(event.line(), "event " + event.name(), "'" + literal + "' is not a number");
      return 0;
    }
  }

  /** The inputs of the model that are properties or constructor arguments of the component. */
  private List<Given> properties() {
    List<Given> properties = new ArrayList<>();
    for (CaseParameter column : suite.parameters()) {
      if (column.kind() != InputKind.TDI) {
        continue;
      }
      if (!Words.isWord(column.name())) {
        problem(
            steps.line(),
            "test_element " + column.name(),
            "is a property of the component, so its name must be an identifier");
        continue;
      }
      if (activity.profile().component().lifeCycle() == LifeCycle.SUITE) {
        problem(
            steps.line(),
            "test_element " + column.name(),
            "is a property of the component, which needs life_cycle: case in activity.yaml");
      }
      properties.add(new Given(column.name(), List.of(), type(column)));
    }
    return properties;
  }

  private DataType type(CaseParameter column) {
    return model.inputs().stream()
        .filter(i -> i.name().equals(column.name()))
        .map(InputElement::type)
        .findFirst()
        .orElse(new DataType.Unknown(column.realType()));
  }

  private HarnessPlan with(HarnessPlan whole, Sequence sequence) {
    errors.addAll(whole.errors());
    return new HarnessPlan(
        whole.modelName(),
        whole.description(),
        whole.interfaceName(),
        whole.method(),
        whole.component(),
        whole.arguments(),
        whole.outputs(),
        whole.world(),
        whole.stubs(),
        whole.before(),
        whole.provided(),
        whole.types(),
        List.copyOf(errors),
        whole.limits(),
        whole.watched(),
        sequence);
  }

  private void problem(int line, String element, String text) {
    diagnostics.error(model.source(), line, element, text);
  }
}
