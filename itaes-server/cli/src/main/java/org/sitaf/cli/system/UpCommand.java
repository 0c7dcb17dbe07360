package org.sitaf.cli.system;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.Installation;
import org.sitaf.cli.OnExit;
import org.sitaf.cli.ProgressLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Server, one agent and the simulation on this machine, until the command is stopped. */
@Command(
    name = "up",
    description =
        "Starts server, one agent and the simulation; what they hold stays in .sitaf/data.",
    mixinStandardHelpOptions = true)
public final class UpCommand implements Callable<Integer> {
  @Spec private @Nullable CommandSpec spec;

  @Option(
      names = "--port",
      defaultValue = "8080",
      description =
          "Of the portal and the REST interface (default: ${DEFAULT-VALUE}; 0: a free one).")
  private int port;

  @Option(
      names = "--grpc-port",
      defaultValue = "9090",
      description = "Of the agents' interface (default: ${DEFAULT-VALUE}; 0: a free one).")
  private int grpcPort;

  @Option(names = "--data", paramLabel = "FOLDER", description = "Instead of .sitaf/data.")
  private @Nullable Path data;

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    Installation installation = Installation.current();
    Path directory = data == null ? installation.state().resolve("data") : data.toAbsolutePath();
    try (OnExit onExit = new OnExit(Thread.currentThread()::interrupt);
        ProgressLine progress = new ProgressLine(System.err);
        LocalSystem system = LocalSystem.start(installation, directory, port, grpcPort, progress)) {
      progress.close();
      PortalInvitation.printAndKeep(system, out);
      return system.await();
    }
  }
}
