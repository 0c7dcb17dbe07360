package org.sitaf.cli.run;

import java.io.IOException;
import java.io.PrintStream;
import java.net.URI;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.git.CheckedOutCommit;
import org.sitaf.cli.system.RemoteRun;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.RosImplementation;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** Whether the agents of a server run the tests. */
final class RemoteOptions {
  @Option(
      names = "--server",
      paramLabel = "URL",
      description = {
        "Runs on the agents of a server instead of this machine, and prints the build log.",
        "SITAF_TOKEN holds an API token of the server. The activity and its results stay there: the"
            + " newest activity of the same name is updated."
      })
  @Nullable URI server;

  @Option(
      names = "--plaintext",
      description = "With --server: allows to send the token without TLS to another machine.")
  private boolean plaintext;

  @Option(
      names = "--activity",
      paramLabel = "ID",
      description = "With --server: updates this activity instead of the one of the same name.")
  private @Nullable String activity;

  @Option(
      names = "--label",
      paramLabel = "KEY=VALUE",
      description =
          "With --server: stored with the builds. The commit of the checkout is stored without it."
              + " Can be repeated.")
  private Map<String, String> labels = new LinkedHashMap<>();

  boolean isRemote() {
    return server != null;
  }

  /** Checks the combination of the options. */
  void check(CommandSpec command) {
    if (server == null && (activity != null || !labels.isEmpty())) {
      throw new CommandLine.ParameterException(
          command.commandLine(), "--activity and --label need --server");
    }
  }

  /** Uploads an activity. */
  RemoteRun upload(Path folder, FileTree files, Activity read, PrintStream err)
      throws IOException, InterruptedException {
    return RemoteRun.upload(
        new RemoteRun.Target(
            Objects.requireNonNull(server), System.getenv("SITAF_TOKEN"), plaintext, activity),
        read.profile().name(),
        files,
        new RemoteRun.Source(CheckedOutCommit.of(folder, files).orElse(""), labels),
        read.rosImplementation().orElse(RosImplementation.INCLUDED),
        err);
  }
}
