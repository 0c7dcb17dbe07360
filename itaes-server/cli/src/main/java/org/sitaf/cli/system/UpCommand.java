package org.sitaf.cli.system;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.terminal.OnExit;
import org.sitaf.cli.terminal.ProgressLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Starts server, agent and simulation until the command is interrupted. */
@Command(
    name = "up",
    description = "Starts server, agent and simulation; their data is stored in .sitaf/data.",
    mixinStandardHelpOptions = true)
public final class UpCommand implements Callable<Integer> {
  @Spec private @Nullable CommandSpec spec;

  @Option(
      names = "--port",
      defaultValue = "8080",
      description =
          "Port of portal and REST interface (default: ${DEFAULT-VALUE}; 0: any free port).")
  private int port;

  @Option(
      names = "--grpc-port",
      defaultValue = "9090",
      description = "Port for agents (default: ${DEFAULT-VALUE}; 0: any free port).")
  private int grpcPort;

  @Option(
      names = "--data",
      paramLabel = "FOLDER",
      description = "Data folder (default: .sitaf/data).")
  private @Nullable Path data;

  @Mixin private final DeviceOptions devices = new DeviceOptions();

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    Installation installation = Installation.current();
    Path directory = data == null ? installation.state().resolve("data") : data.toAbsolutePath();
    try (OnExit onExit = new OnExit(Thread.currentThread()::interrupt);
        ProgressLine progress = new ProgressLine(System.err);
        LocalSystem system =
            LocalSystem.start(
                installation, directory, port, grpcPort, devices.addresses(spec), progress)) {
      progress.close();
      SignInLinks.printAndKeep(system, out);
      return system.await();
    }
  }
}
