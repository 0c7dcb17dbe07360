package org.sitaf.cli;

import java.io.PrintWriter;
import java.io.UncheckedIOException;
import org.sitaf.cli.begin.NewCommand;
import org.sitaf.cli.bisect.BisectCommand;
import org.sitaf.cli.campaign.CampaignCommand;
import org.sitaf.cli.compare.CompareCommand;
import org.sitaf.cli.describe.DescribeCommand;
import org.sitaf.cli.explain.ExplainCommand;
import org.sitaf.cli.explain.ReplayCommand;
import org.sitaf.cli.falsify.FalsifyCommand;
import org.sitaf.cli.lock.LockCommand;
import org.sitaf.cli.run.RunCommand;
import org.sitaf.cli.score.ScoreCommand;
import org.sitaf.cli.system.DemoCommand;
import org.sitaf.cli.system.UpCommand;
import org.sitaf.cli.terminal.FileProblem;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;

/** The command line. Exit code 0 means success; each command documents its other exit codes. */
@Command(
    name = "sitaf",
    description = "Tests the interface of a robot software component against a simulation.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    subcommands = {
      NewCommand.class,
      GenerateCommand.class,
      DescribeCommand.class,
      HarnessCommand.class,
      RunCommand.class,
      FalsifyCommand.class,
      CampaignCommand.class,
      LockCommand.class,
      CompareCommand.class,
      BisectCommand.class,
      ExplainCommand.class,
      ReplayCommand.class,
      ScoreCommand.class,
      DemoCommand.class,
      UpCommand.class
    })
public final class Sitaf {
  /** Exit code after SIGINT, as in a shell. */
  private static final int STOPPED = 130;

  /** The input is invalid, or nothing ran. */
  public static final int UNUSABLE = 2;

  private Sitaf() {}

  /** Runs a command and ends the process with its exit code. */
  public static void main(String[] arguments) {
    System.exit(commandLine().execute(arguments));
  }

  public static CommandLine commandLine() {
    CommandLine sitaf = new CommandLine(new Sitaf());
    sitaf
        .getSubcommands()
        .values()
        .forEach(command -> command.getCommandSpec().versionProvider(new Version()));
    return sitaf
        .setCaseInsensitiveEnumValuesAllowed(true)
        .setExecutionExceptionHandler(
            (failure, command, parsed) -> {
              if (failure instanceof InterruptedException) {
                return STOPPED;
              }
              report(failure, command.getErr());
              return UNUSABLE;
            })
        .setParameterExceptionHandler(
            (failure, arguments) -> {
              PrintWriter err = failure.getCommandLine().getErr();
              err.println("sitaf: " + failure.getMessage());
              err.println(
                  "Try './sitaf " + failure.getCommandLine().getCommandName() + " --help'.");
              return ExitCode.USAGE;
            });
  }

  /** Prints errors of the user without a stack trace. */
  private static void report(Exception failure, PrintWriter err) throws Exception {
    if (failure instanceof InvalidInputException invalid) {
      print(invalid.diagnostics(), err);
    } else if (failure instanceof UncheckedIOException || failure instanceof java.io.IOException) {
      err.println("sitaf: " + Printable.lines(FileProblem.of(failure), "  "));
    } else {
      throw failure;
    }
  }

  /** Prints problems of the user's files, one line each. */
  public static void print(Iterable<Diagnostic> diagnostics, PrintWriter err) {
    diagnostics.forEach(d -> err.println(Printable.lines(d.toString(), "  ")));
    err.flush();
  }
}
