package org.sitaf.core.harness.java;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.Answered;
import org.sitaf.core.harness.java.plan.JavaPlan.World;
import org.sitaf.core.harness.java.plan.JavaText;

/** The view of the test driver of sequences: each step has the five parts of Fig. 10. */
record SequenceDriverView(
    String packageName,
    SortedSet<String> imports,
    String subject,
    String model,
    String description,
    String component,
    String superCall,
    String simulation,
    String stubbing,
    String newComponent,
    List<String> reads,
    String prepareWorld,
    String prepareStub,
    List<String> watches,
    boolean periodic,
    boolean runOn,
    List<Choice> choices,
    List<String> overlapping,
    @Nullable Integer atOnce,
    List<Call> calls,
    List<Event> events) {

  /** Whether a step may overlap the next one. */
  boolean overlaps() {
    return !overlapping.isEmpty();
  }

  /** Which method executes a step. */
  record Choice(String name, String call) {}

  /** The method of a call. */
  record Call(
      String methodUnderTest,
      String callDeclaration,
      String step,
      String method,
      List<String> reads,
      List<String> settings,
      @Nullable String settle,
      List<String> faults,
      @Nullable String answers,
      @Nullable String runFor,
      boolean nonblocking,
      String pendingType,
      boolean returns,
      String expression,
      String call,
      String outcome,
      List<String> outputs) {
    /** Whether the step changes the world. */
    boolean sets() {
      return !settings.isEmpty() || !faults.isEmpty();
    }
  }

  /** The method of an event. */
  record Event(String step, String parameter, String method, String statement) {}

  static SequenceDriverView of(JavaPlan plan) {
    List<Choice> choices = new ArrayList<>();
    List<Call> calls = new ArrayList<>();
    List<Event> events = new ArrayList<>();
    for (JavaPlan.Step step : plan.steps()) {
      JavaPlan call = step.call();
      choices.add(
          new Choice(
              JavaText.string(step.name()),
              step.method() + (call == null ? "()" : "(step, result)")));
      if (call == null) {
        events.add(event(step));
      } else {
        calls.add(call(step, call));
      }
    }
    return new SequenceDriverView(
        plan.packageName(),
        imports(plan),
        JavaText.comment(TestDriverView.subject(plan)),
        JavaText.comment(plan.modelName()),
        JavaText.comment(plan.description()),
        plan.component(),
        TestDriverView.superCall(plan),
        plan.world() == null ? "" : "run.simulation()",
        plan.stubs().isEmpty() ? "" : "run.stubbing()",
        JavaText.call("return", "newComponent", TestDriverView.newComponentArguments(plan)),
        TestDriverView.reads(plan),
        JavaText.call("", "simulationControl.prepare", TestDriverView.settings(plan)),
        JavaText.call(
            "", "testStub.prepare", plan.answers().stream().map(Answered::local).toList()),
        TestDriverView.watches(plan),
        plan.period() != null,
        SimulationControlView.runsOn(plan),
        choices,
        plan.overlapping().stream().map(JavaText::string).toList(),
        plan.threads() > 1 ? Integer.valueOf(plan.threads()) : null,
        calls,
        events);
  }

  private static Call call(JavaPlan.Step step, JavaPlan plan) {
    World world = plan.world();
    return new Call(
        TestDriverView.methodUnderTest(plan),
        TestDriverView.callDeclaration(plan),
        JavaText.comment(step.name()),
        step.method(),
        TestDriverView.reads(plan),
        settings(plan, false),
        world == null || world.settle().isZero()
            ? null
            : SimulationControlView.duration(world.settle()),
        settings(plan, true),
        plan.answers().isEmpty()
            ? null
            : JavaText.call(
                "",
                "testStub." + step.prepare(),
                plan.answers().stream().map(Answered::local).toList()),
        world == null || world.runFor().isZero()
            ? null
            : SimulationControlView.duration(world.runFor()),
        plan.nonblocking(),
        TestDriverView.pendingType(plan),
        plan.returns() != null,
        TestDriverView.expression(plan),
        TestDriverView.call(plan),
        TestDriverView.outcome(plan),
        plan.outputs().stream().map(TestDriverView::output).toList());
  }

  /** Sets the parameters of the world, or the faults, which begin with the call. */
  private static List<String> settings(JavaPlan plan, boolean faults) {
    World world = plan.world();
    return world == null
        ? List.of()
        : world.settings().stream()
            .filter(s -> s.fault() == faults)
            .map(
                s ->
                    JavaText.call(
                        "", "simulationControl.set", List.of(JavaText.string(s.name()), s.local())))
            .toList();
  }

  private static Event event(JavaPlan.Step step) {
    return new Event(
        JavaText.comment(step.name()),
        JavaText.comment(step.parameter()),
        step.method(),
        JavaText.call(
            "",
            "simulationControl.set",
            List.of(JavaText.string(step.parameter()), String.valueOf(step.value()))));
  }

  private static SortedSet<String> imports(JavaPlan plan) {
    SortedSet<String> imports = new TreeSet<>();
    for (String type : List.of("LifeCycle", "SequenceDriver", "TestRun")) {
      imports.add("org.sitaf.runtime." + type);
    }
    for (String type : List.of("CaseResult", "TestCase", "TestStep")) {
      imports.add("org.sitaf.runtime.suite." + type);
    }
    TestDriverView.addTypesOfReads(plan, imports);
    for (JavaPlan call : plan.calls()) {
      TestDriverView.addTypesOfCall(call, imports);
      TestDriverView.addTypesOfReads(call, imports);
      imports.add(
          call.nonblocking()
              ? "org.sitaf.runtime.component.NonblockingCall"
              : "org.sitaf.runtime.Stopwatch");
      World world = call.world();
      if (world != null && !(world.settle().isZero() && world.runFor().isZero())) {
        imports.add("java.time.Duration");
      }
    }
    return imports;
  }
}
