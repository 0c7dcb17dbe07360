package org.sitaf.core.harness.java;

import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.World;
import org.sitaf.core.harness.java.plan.JavaText;

/** The view of the simulation control. */
record SimulationControlView(
    String packageName,
    boolean hasWorld,
    String world,
    String settle,
    String runFor,
    String period,
    boolean periodic,
    boolean runsOn,
    boolean observes,
    boolean sequence,
    List<Setting> settings) {

  /** A parameter of the world that a case sets. */
  record Setting(String name, String local, String documentation, boolean last) {}

  boolean hasSettings() {
    return !settings.isEmpty();
  }

  static SimulationControlView of(JavaPlan plan) {
    World world = plan.world();
    if (world == null) {
      return new SimulationControlView(
          plan.packageName(), false, "", "", "", "", false, false, false, false, List.of());
    }
    Duration period = plan.period();
    return new SimulationControlView(
        plan.packageName(),
        true,
        JavaText.comment(world.path()),
        duration(world.settle()),
        duration(world.runFor()),
        period == null ? "" : duration(period),
        period != null,
        runsOn(plan),
        plan.observes(),
        plan.isSequence(),
        settings(world.settings()));
  }

  private static List<Setting> settings(List<World.Setting> settings) {
    return IntStream.range(0, settings.size())
        .mapToObj(
            i ->
                new Setting(
                    JavaText.string(settings.get(i).name()),
                    settings.get(i).local(),
                    settings.get(i).documentation(),
                    i == settings.size() - 1))
        .toList();
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
