package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.description.CallType;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.World;
import org.sitaf.core.harness.plan.Hooks;
import org.sitaf.core.harness.python.PythonPlan.Answer;

/** The view of the test driver of sequences: each step has the five parts of Fig. 10. */
record SequenceDriverView(
    String subject,
    String model,
    String description,
    String imports,
    String component,
    String suiteLife,
    boolean hasNotHooks,
    String notHooks,
    @Nullable String overlapping,
    @Nullable Integer atOnce,
    String newSimulationControl,
    String make,
    boolean hasInputs,
    String inputs,
    List<String> initialReads,
    String prepareWorld,
    String prepareStub,
    List<String> watches,
    boolean periodic,
    String period,
    boolean runOn,
    List<Choice> choices,
    List<Call> calls,
    List<Event> events) {

  /** Which method executes a step. */
  record Choice(String name, String call) {}

  /** The method of a call. */
  record Call(
      String callDeclaration,
      String methodUnderTest,
      String step,
      String method,
      List<String> reads,
      List<String> settings,
      @Nullable String settle,
      List<String> faults,
      @Nullable String answers,
      @Nullable String runFor,
      boolean nonblocking,
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

  static SequenceDriverView of(PythonPlan plan) {
    HarnessPlan neutral = plan.neutral();
    HarnessPlan.Sequence sequence = Objects.requireNonNull(neutral.sequence());
    List<String> notHooks = Hooks.among(neutral.provided(), PythonNames::snakeCase);
    List<Choice> choices = new ArrayList<>();
    List<Call> calls = new ArrayList<>();
    List<Event> events = new ArrayList<>();
    for (PythonPlan.Step step : plan.steps()) {
      PythonPlan call = step.call();
      choices.add(
          new Choice(
              PythonText.string(step.name()),
              "self." + step.method() + (call == null ? "()" : "(step, result)")));
      if (call == null) {
        events.add(event(step, Objects.requireNonNull(step.event())));
      } else {
        calls.add(call(step, call));
      }
    }
    return new SequenceDriverView(
        TestDriverView.subject(neutral),
        PythonText.plain(neutral.modelName()),
        PythonText.plain(neutral.description()),
        imports(plan),
        plan.component(),
        neutral.component().lifeCycle() == LifeCycle.SUITE ? "True" : "False",
        !notHooks.isEmpty(),
        PythonText.list(
            "NOT_HOOKS = (",
            notHooks.stream().map(PythonText::string).toList(),
            notHooks.size() == 1 ? ",)" : ")"),
        sequence.overlapping().isEmpty()
            ? null
            : PythonText.list(
                "OVERLAPPING = frozenset({",
                sequence.overlapping().stream().map(PythonText::string).toList(),
                "})"),
        sequence.threads() > 1 ? Integer.valueOf(sequence.threads()) : null,
        PythonText.list(
            "self.simulation_control = SimulationControl(",
            neutral.world() == null ? List.of() : List.of("run.simulation"),
            ")"),
        TestDriverView.make(plan),
        !plan.properties().isEmpty(),
        PythonText.list(
            "return {",
            plan.properties().stream()
                .map(
                    p ->
                        PythonText.string(p.column())
                            + ": self.current_case.read("
                            + PythonText.string(p.column())
                            + ", "
                            + PythonType.kind(p.type())
                            + ")")
                .toList(),
            "}"),
        TestDriverView.reads(plan),
        PythonText.list(
            "self.simulation_control.prepare(",
            plan.settings().stream().map(PythonPlan.Setting::local).toList(),
            ")"),
        PythonText.list(
            "self.test_stub.prepare(", plan.answers().stream().map(Answer::local).toList(), ")"),
        TestDriverView.watches(plan),
        plan.isPeriodic(),
        plan.isPeriodic()
            ? PythonText.real(Objects.requireNonNull(neutral.component().period()).toNanos() / 1e9)
            : "",
        plan.runsOn(),
        choices,
        calls,
        events);
  }

  private static Call call(PythonPlan.Step step, PythonPlan plan) {
    World world = plan.neutral().world();
    return new Call(
        TestDriverView.callDeclaration(plan),
        PythonText.plain(plan.neutral().methodName()),
        PythonText.plain(step.name()),
        step.method(),
        TestDriverView.reads(plan),
        settings(plan, false),
        world == null || world.settle().isZero()
            ? null
            : SimulationControlView.seconds(world.settle()),
        settings(plan, true),
        plan.answers().isEmpty()
            ? null
            : PythonText.list(
                "self.test_stub." + step.prepare() + "(",
                plan.answers().stream().map(Answer::local).toList(),
                ")"),
        world == null || world.runFor().isZero()
            ? null
            : SimulationControlView.seconds(world.runFor()),
        plan.neutral().method().callType() == CallType.NONBLOCKING,
        TestDriverView.call(plan),
        TestDriverView.outcome(plan),
        plan.neutral().outputs().stream().map(o -> TestDriverView.output(plan, o)).toList());
  }

  /** Sets the parameters of the world, or the faults, which begin with the call. */
  private static List<String> settings(PythonPlan plan, boolean faults) {
    return plan.settings().stream()
        .filter(s -> s.neutral().isFault() == faults)
        .map(
            s ->
                PythonText.list(
                    "self.simulation_control.set(",
                    List.of(PythonText.string(s.neutral().name()), s.local()),
                    ")"))
        .toList();
  }

  private static Event event(PythonPlan.Step step, HarnessPlan.EventStep event) {
    return new Event(
        PythonText.plain(step.name()),
        PythonText.plain(event.parameter()),
        step.method(),
        PythonText.list(
            "self.simulation_control.set(",
            List.of(PythonText.string(event.parameter()), PythonText.real(event.value())),
            ")"));
  }

  private static String imports(PythonPlan plan) {
    Imports imports =
        new Imports()
            .add("abc", "abstractmethod")
            .add(plan.packageName() + ".simulation_control", "SimulationControl")
            .add(plan.packageName() + ".test_stub", "TestStub")
            .add("sitaf_runtime.run", "TestRun")
            .add("sitaf_runtime.sequence", "SequenceDriver")
            .add("sitaf_runtime.suite.result", "CaseResult")
            .add("sitaf_runtime.suite.test_case", "TestCase")
            .add("sitaf_runtime.suite.test_case", "TestStep");
    TestDriverView.importValues(plan, imports);
    plan.properties().forEach(p -> PythonType.importKind(p.type(), imports));
    for (PythonPlan call : plan.calls()) {
      TestDriverView.importCall(call, imports);
      TestDriverView.importValues(call, imports);
    }
    return imports.text();
  }
}
