package org.sitaf.core.harness.python;

import java.time.Duration;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.core.harness.plan.HarnessPlan.World;

/** The view of the simulation control. */
record SimulationControlView(
    boolean hasWorld,
    String world,
    String settle,
    String runFor,
    boolean runsOn,
    boolean periodic,
    boolean observes,
    boolean sequence,
    String prepare,
    String units,
    String parameters) {

  static SimulationControlView of(PythonPlan plan) {
    World world = plan.neutral().world();
    if (world == null) {
      return new SimulationControlView(false, "", "", "", false, false, false, false, "", "", "");
    }
    return new SimulationControlView(
        true,
        PythonText.plain(world.path()),
        seconds(world.settle()),
        seconds(world.runFor()),
        plan.runsOn(),
        plan.isPeriodic(),
        plan.observes(),
        plan.isSequence(),
        PythonText.list(
            "prepare(",
            Stream.concat(
                    Stream.of("self"), plan.settings().stream().map(s -> s.local() + ": float"))
                .toList(),
            ") -> None:"),
        plan.settings().stream()
            .map(SimulationControlView::documentation)
            .collect(Collectors.joining("; ")),
        plan.settings().isEmpty()
            ? ""
            : plan.settings().stream()
                .map(s -> PythonText.string(s.neutral().name()) + ": " + s.local())
                .collect(Collectors.joining(", ", "{", "}")));
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
