package org.sitaf.core.harness.java;

import java.time.Duration;
import java.util.List;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.World;
import org.sitaf.core.harness.java.plan.JavaText;

/** The view of the simulation control. */
record SimulationControlView(
    String packageName,
    boolean hasWorld,
    String documentation,
    String settle,
    String runFor,
    String period,
    boolean periodic,
    boolean runsOn,
    boolean observes,
    boolean sequence,
    boolean hasSettings,
    String prepareDocumentation,
    String prepareDeclaration,
    List<String> puts) {

  static SimulationControlView of(JavaPlan plan) {
    World world = plan.world();
    if (world == null) {
      return new SimulationControlView(
          plan.packageName(),
          false,
          "",
          "",
          "",
          "",
          false,
          false,
          false,
          false,
          false,
          "",
          "",
          List.of());
    }
    List<World.Setting> settings = world.settings();
    Duration period = plan.period();
    return new SimulationControlView(
        plan.packageName(),
        true,
        JavaText.javadoc(
            0,
            List.of(
                "Simulation control (SC): sets up the virtual environment "
                    + JavaText.comment(world.path())
                    + "."),
            List.of()),
        duration(world.settle()),
        duration(world.runFor()),
        period == null ? "" : duration(period),
        period != null,
        runsOn(plan),
        plan.observes(),
        plan.isSequence(),
        !settings.isEmpty(),
        JavaText.javadoc(
            2,
            List.of(
                period == null
                    ? "Resets the world, sets the parameters of a case, and lets the world settle."
                    : "Resets the world and sets the parameters of a case."),
            settings.stream().map(s -> "@param " + s.local() + " " + s.documentation()).toList()),
        JavaText.declaration(
            2,
            "void prepare",
            settings.stream().map(s -> "double " + s.local()).toList(),
            false,
            " {"),
        settings.stream()
            .map(
                s ->
                    JavaText.call(
                        4, "", "parameters.put", List.of(JavaText.string(s.name()), s.local())))
            .toList());
  }

  /** Whether simulation time passes after the call. */
  static boolean runsOn(JavaPlan plan) {
    return plan.world() != null && !plan.world().runFor().isZero();
  }

  static String duration(Duration time) {
    if (time.isZero()) {
      return "Duration.ZERO";
    }
    return time.toNanos() % 1_000_000 == 0
        ? "Duration.ofMillis(" + time.toMillis() + ")"
        : "Duration.ofNanos(" + time.toNanos() + "L)";
  }
}
