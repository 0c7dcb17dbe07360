package org.sitaf.cli.debug;

import java.util.List;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** Whether the component is debugged. */
public final class DebugOptions {
  @Option(
      names = "--debug",
      description = {
        "Starts gdb, jdb or pdb in this terminal for one case (--case) and stops where the method"
            + " under test begins.",
        "Simulation time stands still meanwhile. The component runs without a sandbox."
      })
  public boolean debug;

  @Option(
      names = "--print-command",
      description =
          "With --debug: prints what another debugger, such as that of an IDE, needs to attach, and"
              + " waits for it.")
  public boolean printCommand;

  @Option(
      names = "--view",
      description =
          "With --debug: serves a page that shows the scene of the case while it runs or stands"
              + " still, for a browser on this machine.")
  public boolean view;

  /**
   * Checks the combination with the other options.
   *
   * @param server whether the cases run on a server
   * @param repeated whether the cases run several times
   * @param sandboxRequired whether the component may run in a sandbox only
   */
  public void check(
      CommandSpec command, boolean server, boolean repeated, boolean sandboxRequired) {
    if (printCommand && !debug) {
      throw new CommandLine.ParameterException(
          command.commandLine(), "--print-command needs --debug");
    }
    if (view && !debug) {
      throw new CommandLine.ParameterException(command.commandLine(), "--view needs --debug");
    }
    if (!debug) {
      return;
    }
    if (server) {
      throw new CommandLine.ParameterException(
          command.commandLine(), "--debug is not available with --server; run the case here");
    }
    if (repeated) {
      throw new CommandLine.ParameterException(
          command.commandLine(),
          "--debug runs a case once; leave out --repeat and --until-failure");
    }
    if (sandboxRequired) {
      throw new CommandLine.ParameterException(
          command.commandLine(),
          "--debug is not available with --sandbox=required: a debugger cannot reach a component in"
              + " the sandbox");
    }
  }

  /**
   * The only model.
   *
   * @throws InvalidInputException if it cannot be debugged
   */
  public TestModel only(Activity activity, List<TestModel> models) {
    if (view && activity.profile().world() == null) {
      throw InvalidInputException.of(
          "activity.yaml", "--view: the activity has no world; leave --view out");
    }
    if (activity.ros() != null) {
      throw InvalidInputException.of(
          "activity.yaml", "--debug: ROS 2 nodes cannot be debugged; test them without --debug");
    }
    if (models.size() != 1) {
      throw InvalidInputException.of(
          "--debug",
          "debugs one case of one model; add --model and one of "
              + String.join(", ", models.stream().map(TestModel::name).toList()));
    }
    return models.get(0);
  }

  /**
   * Checks that one case is selected.
   *
   * @throws InvalidInputException if there are several or none
   */
  public static void requireOneCase(TestModel model, TestSuite selected) {
    int count = selected.cases().size();
    if (count != 1) {
      throw InvalidInputException.of(
          "--debug",
          "debugs one case, but "
              + count
              + (count == 0 ? " cases" : "")
              + " of "
              + model.name()
              + " are selected; add --case and its number");
    }
  }
}
