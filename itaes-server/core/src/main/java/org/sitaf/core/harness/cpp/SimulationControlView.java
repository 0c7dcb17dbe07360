package org.sitaf.core.harness.cpp;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.plan.HarnessPlan.World;

/** The view of the simulation control. */
record SimulationControlView(
    String namespace,
    boolean hasWorld,
    List<String> includes,
    String world,
    List<Setting> settings,
    String parameters,
    String prepareStatement,
    String constructor,
    String settle,
    String runFor,
    String period,
    boolean ahead,
    boolean periodic,
    boolean runsOn,
    boolean observes,
    boolean sequence) {

  /** A parameter of the world that a case sets. */
  record Setting(String local, String name, String unit, String min, String max) {}

  static SimulationControlView of(CppPlan plan) {
    World world = plan.plan().world();
    // If no simulation time passes during a case, the worlds of several cases are prepared in one
    // call.
    boolean ahead = world != null && !plan.runsOn() && !plan.isPeriodic();
    return new SimulationControlView(
        plan.namespace(),
        world != null,
        includes(plan),
        world == null ? "" : CppText.comment(world.path()),
        settings(plan),
        plan.settings().stream().map(s -> "double " + s.local()).collect(Collectors.joining(", ")),
        world == null ? "" : prepareStatement(plan, ahead),
        CppText.constructor(
            "SimulationControl::SimulationControl(runtime::TestRun& run)",
            ahead
                ? List.of("simulation_(run.simulation())", "upcoming_(run.upcoming())")
                : List.of("simulation_(run.simulation())")),
        world == null ? "" : duration(world.settle()),
        world == null ? "" : duration(world.runFor()),
        plan.isPeriodic() ? duration(Objects.requireNonNull(plan.plan().component().period())) : "",
        ahead,
        plan.isPeriodic(),
        plan.runsOn(),
        plan.observes(),
        plan.isSequence());
  }

  private static List<String> includes(CppPlan plan) {
    Includes includes = new Includes().own("sitaf/runtime/test_run.hpp");
    if (plan.isPeriodic()) {
      includes.standard("functional");
    }
    if (plan.isSequence()) {
      includes.standard("chrono");
    }
    if (plan.observes() || plan.isSequence()) {
      includes.standard("string");
    }
    return includes.lines();
  }

  private static List<Setting> settings(CppPlan plan) {
    return plan.settings().stream()
        .map(
            s ->
                new Setting(
                    s.local(),
                    s.setting().name(),
                    CppText.comment(s.setting().unit()),
                    String.valueOf(s.setting().min()),
                    String.valueOf(s.setting().max())))
        .toList();
  }

  private static String prepareStatement(CppPlan plan, boolean ahead) {
    String names =
        String.join(
            ", ", plan.settings().stream().map(s -> CppText.string(s.setting().name())).toList());
    String values =
        String.join(", ", plan.settings().stream().map(CppPlan.Setting::local).toList());
    // A component that is executed periodically settles after the preparation.
    String settle = plan.isPeriodic() ? "std::chrono::nanoseconds(0), settleTime" : "settleTime";
    return CppText.list(
        ahead ? "simulation_.prepareAhead(" : "simulation_.prepare(",
        ahead
            ? List.of("{" + names + "}", "{" + values + "}", settle, "upcoming_")
            : List.of("{" + names + "}", "{" + values + "}", settle),
        ");");
  }

  static String duration(Duration time) {
    return CppText.duration(time);
  }
}
