package org.sitaf.agent.simulation;

import com.google.protobuf.ByteString;
import io.grpc.Grpc;
import io.grpc.InsecureChannelCredentials;
import io.grpc.ManagedChannel;
import io.grpc.ManagedChannelBuilder;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.hardware.DeviceBackend.Range;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.sim.v1.CheckHardwareRequest;
import org.sitaf.sim.v1.CloseEndpointRequest;
import org.sitaf.sim.v1.DescribeWorldRequest;
import org.sitaf.sim.v1.DeviceDescription;
import org.sitaf.sim.v1.GetSimulatorFeaturesRequest;
import org.sitaf.sim.v1.GetSimulatorFeaturesResponse;
import org.sitaf.sim.v1.OpenEndpointRequest;
import org.sitaf.sim.v1.ShowMotionRequest;
import org.sitaf.sim.v1.ShowMotionResponse;
import org.sitaf.sim.v1.Signal;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.SimulatorAdministrationGrpc;
import org.sitaf.sim.v1.StopHardwareRequest;
import org.sitaf.sim.v1.StopHardwareResponse;
import org.sitaf.sim.v1.TakeHardwareReportRequest;
import org.sitaf.sim.v1.TakeHardwareReportResponse;
import org.sitaf.sim.v1.TakeSignalsRequest;
import org.sitaf.sim.v1.TakeSignalsResponse;
import org.sitaf.sim.v1.WorldDescription;
import org.sitaf.sim.v1.WorldSource;

/** Queries a simulator and lets it check a world before a build. */
public final class SimulatorClient implements AutoCloseable {
  private static final int DEADLINE_S = 90;
  private static final int SHORT_DEADLINE_S = 5;
  private static final int MAX_SIGNAL_BYTES = 128 << 20;

  /**
   * Netty warns about an option that Unix sockets do not have. A field keeps the logger, whose
   * level would be garbage collected otherwise.
   */
  private static final Logger SOCKET_OPTIONS =
      Logger.getLogger("io.grpc.netty.shaded.io.netty.bootstrap.Bootstrap");

  private final ManagedChannel channel;
  private final String target;

  /** Connects to a gRPC target. */
  public SimulatorClient(String target) {
    this.target = target;
    SOCKET_OPTIONS.setLevel(Level.SEVERE);
    // The registry finds the transport for Unix sockets.
    ManagedChannelBuilder<?> builder =
        Grpc.newChannelBuilder(target, InsecureChannelCredentials.create());
    if (target.startsWith("unix:")) {
      // A socket path is not a valid host name for servers.
      builder.overrideAuthority("localhost");
    }
    this.channel = builder.build();
  }

  /**
   * Name and version, such as {@code sitaf-bridge 0.1.0 (MuJoCo 4.0.0)}.
   *
   * @throws SimulatorException if it does not answer
   */
  public String version() throws SimulatorException {
    try {
      GetSimulatorFeaturesResponse features =
          stub().getSimulatorFeatures(GetSimulatorFeaturesRequest.getDefaultInstance());
      return "sitaf-bridge "
          + features.getBridgeVersion()
          + " ("
          + features.getEngine()
          + " "
          + features.getEngineVersion()
          + ")";
    } catch (StatusRuntimeException e) {
      throw noAnswer(e);
    }
  }

  /**
   * Checks that the simulator answers.
   *
   * @throws SimulatorException if it does not
   */
  void requireAnswer() throws SimulatorException {
    try {
      GetSimulatorFeaturesResponse unused =
          stub()
              .withDeadlineAfter(SHORT_DEADLINE_S, TimeUnit.SECONDS)
              .getSimulatorFeatures(GetSimulatorFeaturesRequest.getDefaultInstance());
    } catch (StatusRuntimeException e) {
      throw noAnswer(e);
    }
  }

  /**
   * Whether the simulator opens endpoints, as a bridge with {@code --endpoints} does.
   *
   * @throws SimulatorException if it does not answer
   */
  public boolean opensEndpoints() throws SimulatorException {
    try {
      ShowMotionResponse unused =
          administration().showMotion(ShowMotionRequest.getDefaultInstance());
      return true;
    } catch (StatusRuntimeException e) {
      return switch (e.getStatus().getCode()) {
        case NOT_FOUND -> true;
        case UNIMPLEMENTED -> false;
        default -> throw noAnswer(e);
      };
    }
  }

  /**
   * Opens an endpoint.
   *
   * @param worldDigest digest of the only world that the endpoint offers
   * @param signals what its session samples at each step; null for nothing
   * @param hardware the devices that are not simulated; null if all are
   * @return the gRPC target of the endpoint
   * @throws SimulatorException if the bridge refuses
   */
  String openEndpoint(
      String name,
      String worldDigest,
      @Nullable SignalOrder signals,
      org.sitaf.sim.v1.@Nullable HardwareOrder hardware)
      throws SimulatorException {
    OpenEndpointRequest.Builder request =
        OpenEndpointRequest.newBuilder().setName(name).setWorldDigest(worldDigest);
    if (signals != null) {
      request.getSignalsBuilder().addAllNames(signals.names()).setSettling(signals.settling());
    }
    if (hardware != null) {
      request.setHardware(hardware);
    }
    try {
      return administration().openEndpoint(request.build()).getTarget();
    } catch (StatusRuntimeException e) {
      throw noAnswer(e);
    }
  }

  /**
   * Takes the signals of a case from an endpoint.
   *
   * @return empty if the endpoint has none
   * @throws SimulatorException if the bridge refuses, or if the component interfered
   */
  Optional<Trace> takeSignals(String endpoint, int no) throws SimulatorException {
    TakeSignalsResponse taken;
    try {
      taken =
          SimulatorAdministrationGrpc.newBlockingStub(channel)
              .withMaxInboundMessageSize(MAX_SIGNAL_BYTES)
              .withDeadlineAfter(DEADLINE_S, TimeUnit.SECONDS)
              .takeSignals(TakeSignalsRequest.newBuilder().setName(endpoint).setCaseNo(no).build());
    } catch (StatusRuntimeException e) {
      throw switch (e.getStatus().getCode()) {
        case RESOURCE_EXHAUSTED, INVALID_ARGUMENT, DATA_LOSS ->
            new SimulatorException(String.valueOf(e.getStatus().getDescription()), e);
        default -> noAnswer(e);
      };
    }
    if (taken.getTimesKept() == 0) {
      return Optional.empty();
    }
    if (taken.getTimesKept() > 1) {
      throw new SimulatorException(
          "the signals were kept " + taken.getTimesKept() + " times; the component interfered");
    }
    List<String> names = taken.getSignalsList().stream().map(Signal::getName).toList();
    List<double[]> columns =
        taken.getSignalsList().stream()
            .map(s -> s.getValuesList().stream().mapToDouble(Double::doubleValue).toArray())
            .toList();
    try {
      return Optional.of(new Trace(taken.getFirstNs(), taken.getTimestepNs(), names, columns));
    } catch (IllegalArgumentException e) {
      throw new SimulatorException("the signals are not complete: " + e.getMessage(), e);
    }
  }

  /**
   * The recorded motion of the session of an endpoint, which goes on.
   *
   * @return empty if nothing changed since the known version, or nothing is recorded
   * @throws SimulatorException if the bridge does not answer
   */
  Optional<LiveMotion.Motion> motion(String endpoint, long known) throws SimulatorException {
    try {
      ShowMotionResponse shown =
          SimulatorAdministrationGrpc.newBlockingStub(channel)
              .withMaxInboundMessageSize(MAX_SIGNAL_BYTES)
              .withDeadlineAfter(SHORT_DEADLINE_S, TimeUnit.SECONDS)
              .showMotion(
                  ShowMotionRequest.newBuilder().setName(endpoint).setKnownVersion(known).build());
      return shown.getGltf().isEmpty()
          ? Optional.empty()
          : Optional.of(new LiveMotion.Motion(shown.getGltf().toByteArray(), shown.getVersion()));
    } catch (StatusRuntimeException e) {
      return switch (e.getStatus().getCode()) {
        // A long step runs, or the case has not begun, has ended, or diverged.
        case DEADLINE_EXCEEDED, NOT_FOUND, FAILED_PRECONDITION, DATA_LOSS -> Optional.empty();
        case RESOURCE_EXHAUSTED ->
            throw new SimulatorException(String.valueOf(e.getStatus().getDescription()), e);
        default -> throw noAnswer(e);
      };
    }
  }

  /**
   * Compares devices that are not simulated with a world.
   *
   * @param parameters names of parameters that a test sets
   * @return what serves each device
   * @throws WorldException if a device does not fit
   * @throws SimulatorException if a provider or the simulator does not answer
   */
  List<String> checkHardware(
      String description,
      Map<String, byte[]> files,
      org.sitaf.sim.v1.HardwareOrder hardware,
      Set<String> parameters)
      throws WorldException, SimulatorException {
    try {
      return SimulatorAdministrationGrpc.newBlockingStub(channel)
          .withDeadlineAfter(DEADLINE_S, TimeUnit.SECONDS)
          .checkHardware(
              CheckHardwareRequest.newBuilder()
                  .setWorld(source(description, files))
                  .setHardware(hardware)
                  .addAllParameters(parameters)
                  .build())
          .getDescriptionsList();
    } catch (StatusRuntimeException e) {
      String message = String.valueOf(e.getStatus().getDescription());
      Status.Code code = e.getStatus().getCode();
      if (code == Status.Code.INVALID_ARGUMENT) {
        throw new WorldException(message);
      }
      throw code == Status.Code.FAILED_PRECONDITION
          ? new SimulatorException(message, e)
          : noAnswer(e);
    }
  }

  /**
   * Ends a case with devices that are not simulated, and returns what was measured.
   *
   * @throws SimulatorException if the bridge does not answer
   */
  TakeHardwareReportResponse takeHardwareReport(String endpoint, int no) throws SimulatorException {
    try {
      return administration()
          .takeHardwareReport(
              TakeHardwareReportRequest.newBuilder().setName(endpoint).setCaseNo(no).build());
    } catch (StatusRuntimeException e) {
      throw noAnswer(e);
    }
  }

  /** Stops the devices of an endpoint safely. The guard does so if the bridge does not answer. */
  void stopHardware(String endpoint) {
    try {
      StopHardwareResponse unused =
          administration().stopHardware(StopHardwareRequest.newBuilder().setName(endpoint).build());
    } catch (StatusRuntimeException e) {
      // The guard stops devices whose simulator has ended.
    }
  }

  private static WorldSource.Builder source(String description, Map<String, byte[]> files) {
    WorldSource.Builder world = WorldSource.newBuilder().setDescription(description);
    files.forEach((path, content) -> world.putFiles(path, ByteString.copyFrom(content)));
    return world;
  }

  /**
   * Closes an endpoint; returns whether all its calls have ended, false if the bridge does not
   * answer.
   */
  boolean closesEndpoint(String name) {
    try {
      return administration()
          .closeEndpoint(CloseEndpointRequest.newBuilder().setName(name).build())
          .getIdle();
    } catch (StatusRuntimeException e) {
      return false;
    }
  }

  /**
   * Lets the simulator compile a world.
   *
   * @param description name of the world description among the files
   * @param files of the world's folder, by relative path
   * @param faults names of faults that a test sets
   * @throws WorldException if the simulator rejects it
   * @throws SimulatorException if it does not answer
   */
  CompiledWorld check(String description, Map<String, byte[]> files, Set<String> faults)
      throws WorldException, SimulatorException {
    try {
      WorldDescription described =
          stub()
              .describeWorld(
                  DescribeWorldRequest.newBuilder()
                      .setWorld(source(description, files))
                      .addAllParameters(faults)
                      .build())
              .getWorld();
      Map<String, Map<String, Range>> commands = new HashMap<>();
      for (DeviceDescription device : described.getDevicesList()) {
        Map<String, Range> numbers = new HashMap<>();
        device
            .getCommandsList()
            .forEach(n -> numbers.put(n.getName(), new Range(n.getMin(), n.getMax())));
        commands.put(device.getName(), numbers);
      }
      return new CompiledWorld(described.getDigest(), described.getTimestepNs(), commands);
    } catch (StatusRuntimeException e) {
      Status.Code code = e.getStatus().getCode();
      if (code == Status.Code.INVALID_ARGUMENT
          || code == Status.Code.OUT_OF_RANGE
          || code == Status.Code.RESOURCE_EXHAUSTED) {
        throw new WorldException(String.valueOf(e.getStatus().getDescription()));
      }
      throw noAnswer(e);
    }
  }

  private SimulationControlGrpc.SimulationControlBlockingStub stub() {
    return SimulationControlGrpc.newBlockingStub(channel)
        .withDeadlineAfter(DEADLINE_S, TimeUnit.SECONDS);
  }

  private SimulatorAdministrationGrpc.SimulatorAdministrationBlockingStub administration() {
    return SimulatorAdministrationGrpc.newBlockingStub(channel)
        .withDeadlineAfter(SHORT_DEADLINE_S, TimeUnit.SECONDS);
  }

  private SimulatorException noAnswer(StatusRuntimeException e) {
    return new SimulatorException(
        "the simulator at " + target + " does not answer: " + e.getStatus(), e);
  }

  @Override
  public void close() {
    channel.shutdownNow();
  }
}
