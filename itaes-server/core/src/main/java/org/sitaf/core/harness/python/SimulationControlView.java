package org.sitaf.core.harness.python;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.harness.plan.HarnessPlan.World;
import org.sitaf.core.harness.python.PythonText.Group;

/** The view of the simulation control. */
record SimulationControlView(
    boolean hasWorld,
    String documentation,
    String settle,
    String runFor,
    boolean runsOn,
    boolean periodic,
    boolean observes,
    boolean sequence,
    String prepareDeclaration,
    String prepareDocumentation,
    String prepare) {

  static SimulationControlView of(PythonPlan plan) {
    World world = plan.neutral().world();
    if (world == null) {
      return new SimulationControlView(false, "", "", "", false, false, false, false, "", "", "");
    }
    String parameters =
        new Group(
                "parameters = {",
                plan.settings().stream()
                    .map(s -> PythonText.string(s.neutral().name()) + ": " + s.local())
                    .toList(),
                "}")
            .at(8);
    String call =
        "self._simulation.prepare(parameters"
            + (plan.isPeriodic() ? ", call_after_s=SETTLE)" : ", SETTLE)");
    List<String> documentation = new ArrayList<>();
    documentation.add(
        plan.isPeriodic()
            ? "Reset the world and set the parameters of a case."
            : "Reset the world, set the parameters of a case, and let the world settle.");
    if (!plan.settings().isEmpty()) {
      documentation.add(
          String.join(
                  "; ", plan.settings().stream().map(SimulationControlView::documentation).toList())
              + ".");
    }
    return new SimulationControlView(
        true,
        PythonText.docstring(
            0,
            List.of(
                "Simulation control (SC).",
                "Sets up the virtual environment " + PythonText.plain(world.path()) + ".")),
        seconds(world.settle()),
        seconds(world.runFor()),
        plan.runsOn(),
        plan.isPeriodic(),
        plan.observes(),
        plan.isSequence(),
        new Group(
                "def prepare(",
                Stream.concat(
                        Stream.of("self"), plan.settings().stream().map(s -> s.local() + ": float"))
                    .toList(),
                ") -> None:")
            .at(4),
        PythonText.docstring(8, documentation),
        (plan.settings().isEmpty() ? "        parameters: dict[str, float] = {}" : parameters)
            + "\n        "
            + call);
  }

  private static String documentation(PythonPlan.Setting setting) {
    return setting.local()
        + " in "
        + PythonText.plain(setting.neutral().unit())
        + ", from "
        + setting.neutral().min()
        + " to "
        + setting.neutral().max();
  }

  static String seconds(Duration time) {
    return PythonText.real(time.toNanos() / 1e9);
  }
}
