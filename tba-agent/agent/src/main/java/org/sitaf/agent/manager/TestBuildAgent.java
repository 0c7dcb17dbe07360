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
import org.sitaf.agent.build.OfferedDevices;
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

/** A running test build agent. */
public final class TestBuildAgent implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");

  /** How an agent registers the ROS 2 of its machine. */
  private static final String ROS = "ros";

  /** Label of agents that run components in a sandbox. */
  private static final String SANDBOXED = "sandbox";

  private static final int MAX_MESSAGE_BYTES = 16 << 20;
  private static final Duration KEEP_ALIVE_TIMEOUT = Duration.ofSeconds(20);
  private static final Duration STOP_TIMEOUT = Duration.ofSeconds(5);

  /** Margin, so that the limits of a process take effect before its file system is full. */
  private static final int MARGIN_MIB = 64;

  private static final int MARGIN_FILES = 4000;

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
   * Starts an agent, which connects to the server and reconnects until it is closed.
   *
   * @param onRegistered receives the server's version after each registration
   * @throws IOException if the agent's folder cannot be used, or a required sandbox is missing
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
    // Processes that a killed agent left running would disturb builds.
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
            .within(settings.longestBuild())
            .offering(new OfferedDevices(settings.devices(), false));
    this.disk = new FreeSpace(directory.path(), settings.minFreeBytes());
    this.trash = directory.trash();
    this.attempts =
        new Attempts(
            settings.slots(),
            directory.builds(
                trash,
                BuildRun.WRITTEN,
                DiskLimits.COMPONENT.mebibytes() + MARGIN_MIB,
                DiskLimits.COMPONENT.files() + MARGIN_FILES),
            builds,
            calls,
            directory.fileCache(),
            upload,
            disk,
            this::requestHeartbeat);
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
      // Detects servers that disappear without closing the connection.
      builder.withOption(EpollChannelOption.TCP_USER_TIMEOUT, (int) KEEP_ALIVE_TIMEOUT.toMillis());
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

  private void requestHeartbeat() {
    connection.requestHeartbeat();
  }

  private Register registration() {
    Register.Builder register =
        Register.newBuilder()
            .setName(settings.name())
            .setVersion(settings.version())
            .setSlots(settings.slots())
            .addAllLabels(settings.labels())
            .addAllDevices(settings.devices().keySet())
            .setSimulation(settings.bridge() != null || !settings.bridgeCommand().isEmpty())
            .setRefuses(disk.whyFull())
            .setAnalyses(true)
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
                        .setLanguage(toolchain.language().id())
                        .setVersion(toolchain.version())));
    toolchains
        .ros()
        .ifPresent(
            ros ->
                register.addToolchains(
                    Toolchain.newBuilder().setLanguage(ROS).setVersion(ros.version())));
    return register.build();
  }

  private final class FromServer implements ServerConnection.Listener {
    @Override
    public void registered(Registered registered) {
      upload.wake();
      onRegistered.accept(registered.getServerVersion());
    }

    @Override
    public void leaseLost() {
      attempts.stopWithDevices();
    }

    @Override
    public void message(ServerMessage message) {
      switch (message.getMessageCase()) {
        case ASSIGNMENT -> attempts.begin(message.getAssignment());
        case CANCELLATION -> attempts.cancel(message.getCancellation());
        default -> {
          // A message of a newer server; builds do not depend on it.
        }
      }
    }
  }

  /** Stops builds, informs the server if possible, and ends the agent's processes. */
  @Override
  public void close() {
    // A failing step must not prevent the others.
    runAndLog(() -> attempts.stop(STOP_TIMEOUT));
    runAndLog(upload::close);
    runAndLog(connection::close);
    runAndLog(channel::shutdownNow);
    runAndLog(toolchains::stop);
    runAndLog(simulator::close);
    runAndLog(trash::close);
    try {
      directory.close();
    } catch (IOException e) {
      // The lock is released when the process ends.
    }
  }

  /**
   * Catches errors, too, because classes are missing if the installation was replaced while the
   * agent ran.
   */
  private static void runAndLog(Runnable step) {
    try {
      step.run();
    } catch (RuntimeException | LinkageError e) {
      LOGGER.log(System.Logger.Level.WARNING, "error while the agent stops: " + e);
    }
  }
}
