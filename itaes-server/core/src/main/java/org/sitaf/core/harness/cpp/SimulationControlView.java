package org.sitaf.core.harness.cpp;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.plan.HarnessPlan.World;

/** The view of the simulation control. */
record SimulationControlView(
    String namespace,
    boolean hasWorld,
    List<String> includes,
    String documentation,
    String prepareDocumentation,
    String prepareDeclaration,
    String prepareHead,
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

  static SimulationControlView of(CppPlan plan) {
    World world = plan.plan().world();
    // If no simulation time passes during a case, the worlds of several cases are prepared in one
    // call.
    boolean ahead = world != null && !plan.runsOn() && !plan.isPeriodic();
    List<String> parameters = plan.settings().stream().map(s -> "double " + s.local()).toList();
    return new SimulationControlView(
        plan.namespace(),
        world != null,
        includes(plan),
        CppText.documentation(
            0,
            List.of(
                world == null
                    ? "Simulation control (SC): not used, because the activity has no world."
                    : "Simulation control (SC): sets up the virtual environment "
                        + CppText.comment(world.path())
                        + ".")),
        prepareDocumentation(plan),
        CppText.list(2, "void prepare(", parameters, ");"),
        CppText.list(0, "void SimulationControl::prepare(", parameters, ") {"),
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

  private static String prepareDocumentation(CppPlan plan) {
    List<String> paragraphs = new ArrayList<>();
    paragraphs.add(
        plan.isPeriodic()
            ? "Resets the world and sets the parameters of a case."
            : "Resets the world, sets the parameters of a case, and lets the world settle.");
    plan.settings()
        .forEach(
            s ->
                paragraphs.add(
                    "- "
                        + s.local()
                        + ": "
                        + s.setting().name()
                        + " in "
                        + CppText.comment(s.setting().unit())
                        + ", from "
                        + s.setting().min()
                        + " to "
                        + s.setting().max()));
    return CppText.documentation(2, paragraphs);
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
        2,
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
