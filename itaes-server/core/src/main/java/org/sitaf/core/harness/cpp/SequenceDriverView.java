package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.CallType;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.World;

/** The view of the test driver of sequences: each step has the five parts of Fig. 10. */
record SequenceDriverView(
    String namespace,
    List<String> includes,
    String called,
    String model,
    String description,
    String component,
    String constructor,
    String newComponent,
    List<String> reads,
    String prepareWorld,
    String prepareStub,
    List<String> watches,
    boolean settles,
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
  record Choice(String condition, String call) {}

  /** The method of a call. */
  record Call(
      String called,
      String callHead,
      String step,
      String method,
      List<String> reads,
      List<String> settings,
      @Nullable String settle,
      List<String> faults,
      @Nullable String answers,
      @Nullable String runFor,
      boolean blocking,
      String call,
      String collect,
      List<String> outputs) {
    /** Whether the step changes the world. */
    boolean sets() {
      return !settings.isEmpty() || !faults.isEmpty();
    }
  }

  /** The method of an event. */
  record Event(String step, String parameter, String method, String statement) {}

  static SequenceDriverView of(CppPlan plan) {
    HarnessPlan.Sequence sequence = Objects.requireNonNull(plan.plan().sequence());
    List<Choice> choices = new ArrayList<>();
    List<Call> calls = new ArrayList<>();
    List<Event> events = new ArrayList<>();
    for (CppPlan.Step step : plan.steps()) {
      CppPlan call = step.call();
      choices.add(
          new Choice(
              "step.name() == " + CppText.string(step.name()),
              step.method() + (call == null ? "()" : "(step, result)")));
      if (call == null) {
        events.add(event(step, Objects.requireNonNull(step.event())));
      } else {
        calls.add(call(step, call));
      }
    }
    return new SequenceDriverView(
        plan.namespace(),
        TestDriverView.includes(plan),
        plan.called(),
        CppText.comment(plan.plan().modelName()),
        CppText.comment(plan.plan().description()),
        plan.component(),
        TestDriverView.constructor(plan),
        CppText.list(
            "return runtime::createComponent<Component>(", TestDriverView.offered(plan), ");"),
        TestDriverView.reads(plan),
        CppText.list(
            "simulationControl_.prepare(",
            plan.settings().stream().map(CppPlan.Setting::local).toList(),
            ");"),
        CppText.list(
            "testStub_.prepare(",
            plan.answers().stream().map(CppPlan.Answer::local).toList(),
            ");"),
        TestDriverView.watches(plan),
        plan.isPeriodic() && plan.hasWorld(),
        plan.runsOn(),
        choices,
        sequence.overlapping().stream().map(n -> "step.name() == " + CppText.string(n)).toList(),
        sequence.threads() > 1 ? Integer.valueOf(sequence.threads()) : null,
        calls,
        events);
  }

  private static Call call(CppPlan.Step step, CppPlan plan) {
    World world = plan.plan().world();
    return new Call(
        plan.called(),
        plan.callHead(),
        CppText.comment(step.name()),
        step.method(),
        TestDriverView.reads(plan),
        settings(plan, false),
        world == null || world.settle().isZero()
            ? null
            : SimulationControlView.duration(world.settle()),
        settings(plan, true),
        plan.answers().isEmpty()
            ? null
            : CppText.list(
                "testStub_." + step.prepare() + "(",
                plan.answers().stream().map(CppPlan.Answer::local).toList(),
                ");"),
        world == null || world.runFor().isZero()
            ? null
            : SimulationControlView.duration(world.runFor()),
        plan.plan().method().callType() != CallType.NONBLOCKING,
        TestDriverView.call(plan),
        TestDriverView.collect(plan),
        plan.plan().outputs().stream().map(o -> TestDriverView.output(plan, o)).toList());
  }

  /** Sets the parameters of the world, or the faults, which begin with the call. */
  private static List<String> settings(CppPlan plan, boolean faults) {
    return plan.settings().stream()
        .filter(s -> s.setting().isFault() == faults)
        .map(
            s ->
                CppText.list(
                    "simulationControl_.set(",
                    List.of(CppText.string(s.setting().name()), s.local()),
                    ");"))
        .toList();
  }

  private static Event event(CppPlan.Step step, HarnessPlan.EventStep event) {
    return new Event(
        CppText.comment(step.name()),
        CppText.comment(event.parameter()),
        step.method(),
        CppText.list(
            "simulationControl_.set(",
            List.of(CppText.string(event.parameter()), String.valueOf(event.value())),
            ");"));
  }
}
