package org.sitaf.agent.manager;

import io.grpc.ClientInterceptors;
import io.grpc.ManagedChannel;
import io.grpc.netty.shaded.io.grpc.netty.NettyChannelBuilder;
import io.grpc.netty.shaded.io.netty.channel.epoll.Epoll;
import io.grpc.netty.shaded.io.netty.channel.epoll.EpollChannelOption;
import java.io.IOException;
import java.time.Duration;
import java.util.function.Consumer;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.sandbox.DiskLimits;
import org.sitaf.agent.sandbox.ProcessGroup;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.spool.AgentDirectory;
import org.sitaf.agent.spool.FreeSpace;
import org.sitaf.agent.spool.Trash;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.Registered;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.agent.v1.Toolchain;
import org.sitaf.core.activity.ActivityProfile.Language;

/** A test build agent at work, from its start to {@link #close()}. */
public final class TestBuildAgent implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");

  /** By this label a build can ask for an agent that keeps components in a sandbox. */
  private static final String SANDBOXED = "sandbox";

  private static final int MAX_MESSAGE_BYTES = 16 << 20;
  private static final Duration UNACKNOWLEDGED = Duration.ofSeconds(20);
  private static final Duration STOP = Duration.ofSeconds(5);

  /** So that who exceeds a limit is seen to do so before its file system is full. */
  private static final int BEYOND_MIB = 64;

  private static final int BEYOND_FILES = 4000;

  private final AgentSettings settings;
  private final Toolchains toolchains;
  private final Consumer<String> onRegistered;
  private final AgentDirectory directory;
  private final Sandbox sandbox;
  private final Simulator simulator;
  private final ManagedChannel channel;
  private final ResultUpload upload;
  private final FreeSpace disk;
  private final Trash trash;
  private final Attempts attempts;
  private final ServerConnection connection;

  /**
   * Starts an agent. It dials the server for as long as it lives, whether the server is there or
   * not.
   *
   * @param onRegistered is told the server's version each time that the server knows the agent
   * @throws IOException if the agent's folder cannot be used, or a sandbox is required and there is
   *     none
   */
  public TestBuildAgent(
      AgentSettings settings, Toolchains toolchains, Consumer<String> onRegistered)
      throws IOException {
    this.settings = settings;
    this.toolchains = toolchains;
    this.onRegistered = onRegistered;
    this.sandbox = settings.sandbox().open();
    LOGGER.log(System.Logger.Level.INFO, sandbox.description());
    this.directory = AgentDirectory.open(settings.directory());
    // What an agent that was killed left running would disturb the builds to come.
    new ProcessGroup(ProcessGroup.markOf(directory.path())).kill();
    this.simulator = simulatorOf(settings, directory, sandbox);
    AgentKey key =
        AgentKey.open(
            directory.path().resolve("key"), settings.name(), settings.access().enrolmentToken());
    this.channel = channelTo(settings.server(), settings.access());
    ServerCalls calls = new ServerCalls(ClientInterceptors.intercept(channel, key));
    this.upload = new ResultUpload(directory.spool(), calls);
    BuildSettings builds =
        new BuildSettings(
                simulator,
                toolchains,
                sandbox,
                settings.coverage(),
                settings.name() + " " + settings.version())
            .within(settings.longestBuild());
    this.disk = new FreeSpace(directory.path(), settings.minFreeBytes());
    this.trash = directory.trash();
    this.attempts =
        new Attempts(
            settings.slots(),
            directory.builds(
                trash,
                BuildRun.WRITTEN,
                DiskLimits.COMPONENT.mebibytes() + BEYOND_MIB,
                DiskLimits.COMPONENT.files() + BEYOND_FILES),
            builds,
            calls,
            directory.fileCache(),
            upload,
            disk,
            this::beatSoon);
    this.connection =
        new ServerConnection(
            channel, key, this::registration, attempts::refs, disk::whyFull, new FromServer());
    connection.start();
    toolchains.startAhead(Language.JAVA, sandbox);
  }

  private static ManagedChannel channelTo(String server, ServerAccess access) throws IOException {
    NettyChannelBuilder builder =
        NettyChannelBuilder.forTarget(
                ServerAddresses.target(server), access.channelCredentials(server))
            .maxInboundMessageSize(MAX_MESSAGE_BYTES);
    if (Epoll.isAvailable()) {
      // Heartbeats that nobody acknowledges tell of a server that vanished without a word.
      builder.withOption(EpollChannelOption.TCP_USER_TIMEOUT, (int) UNACKNOWLEDGED.toMillis());
    }
    return builder.build();
  }

  private static Simulator simulatorOf(
      AgentSettings settings, AgentDirectory directory, Sandbox sandbox) {
    if (settings.bridge() != null) {
      return Simulator.running(settings.bridge());
    }
    return settings.bridgeCommand().isEmpty()
        ? Simulator.none()
        : Simulator.started(
            settings.bridgeCommand(),
            directory.path().resolve("bridge"),
            sandbox,
            Simulator.UNLIMITED);
  }

  private void beatSoon() {
    connection.beatSoon();
  }

  private Register registration() {
    Register.Builder register =
        Register.newBuilder()
            .setName(settings.name())
            .setVersion(settings.version())
            .setSlots(settings.slots())
            .addAllLabels(settings.labels())
            .setSimulation(settings.bridge() != null || !settings.bridgeCommand().isEmpty())
            .setRefuses(disk.whyFull())
            .addAllRunning(attempts.refs());
    if (!sandbox.kind().equals(Sandbox.NONE) && !settings.labels().contains(SANDBOXED)) {
      register.addLabels(SANDBOXED);
    }
    toolchains
        .found()
        .forEach(
            toolchain ->
                register.addToolchains(
                    Toolchain.newBuilder()
                        .setLanguage(toolchain.language().spelling())
                        .setVersion(toolchain.version())));
    return register.build();
  }

  private final class FromServer implements ServerConnection.Listener {
    @Override
    public void registered(Registered registered) {
      upload.wake();
      onRegistered.accept(registered.getServerVersion());
    }

    @Override
    public void message(ServerMessage message) {
      switch (message.getMessageCase()) {
        case ASSIGNMENT -> attempts.begin(message.getAssignment());
        case CANCELLATION -> attempts.cancel(message.getCancellation());
        default -> {
          // A message of a later release; the builds do not depend on it.
        }
      }
    }
  }

  /** Stops what runs, tells the server if it is there, and ends the agent's own processes. */
  @Override
  public void close() {
    // What cannot be ended properly must not keep the rest from its end.
    orElseLogged(() -> attempts.stop(STOP));
    orElseLogged(upload::close);
    orElseLogged(connection::close);
    orElseLogged(channel::shutdownNow);
    orElseLogged(toolchains::stop);
    orElseLogged(simulator::close);
    orElseLogged(trash::close);
    try {
      directory.close();
    } catch (IOException e) {
      // The lock goes with the process at the latest.
    }
  }

  /**
   * Also when its classes are gone, because the installation was replaced under a running agent.
   */
  private static void orElseLogged(Runnable step) {
    try {
      step.run();
    } catch (RuntimeException | LinkageError e) {
      LOGGER.log(System.Logger.Level.WARNING, "the agent does not end properly: " + e);
    }
  }
}
