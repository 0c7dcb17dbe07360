package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.PortSignals;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan.Output;
import org.sitaf.core.harness.plan.HarnessPlan.Source;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.trajectory.TrajectoryConditions;

/** Finds the output data ports that the trajectory conditions of a model use. */
final class WatchedPorts {
  private WatchedPorts() {}

  static List<Output> of(Activity activity, TestModel model) {
    WorldDescription world = activity.world();
    List<Output> watched = new ArrayList<>();
    if (world == null || activity.outputPorts().isEmpty()) {
      return watched;
    }
    TrajectoryConditions conditions =
        TrajectoryConditions.compile(
            model,
            activity.signals(model),
            activity.signalLists(model),
            activity.profile().limits().caseSimulation().toNanos() / 1e9,
            // The activity was verified before.
            new Diagnostics());
    for (String signal : conditions.signals()) {
      PortSignals.type(activity.outputPorts(), signal)
          .ifPresent(
              type ->
                  watched.add(
                      new Output(
                          signal,
                          new Source.DataPort(MemberPath.root(signal), MemberPath.steps(signal)),
                          type)));
    }
    return watched;
  }
}
