package org.sitaf.runtime.simulation;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.sim.v1.CreateSessionRequest;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeleteSessionRequest;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.KeepSignalsRequest;
import org.sitaf.sim.v1.KeepSignalsResponse;
import org.sitaf.sim.v1.OperateRequest;
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.PrepareManyResponse;
import org.sitaf.sim.v1.PrepareRequest;
import org.sitaf.sim.v1.ReadDevicesRequest;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.RecordMotionRequest;
import org.sitaf.sim.v1.RecordMotionResponse;
import org.sitaf.sim.v1.RenewSessionRequest;
import org.sitaf.sim.v1.SetParametersRequest;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.SimulationControlGrpc.SimulationControlBlockingStub;
import org.sitaf.sim.v1.StepSimulationRequest;
import org.sitaf.sim.v1.TakeMotionRequest;
import org.sitaf.sim.v1.VirtualHardwareGrpc;
import org.sitaf.sim.v1.VirtualHardwareGrpc.VirtualHardwareBlockingStub;
import org.sitaf.sim.v1.WorldState;
import org.sitaf.sim.v1.WriteDevicesRequest;

/**
 * The calls of one session to the simulator, and whether the simulator is lost. The calls throw
 * {@link StatusRuntimeException}; {@link #ask}, {@link #lost} and {@link #rejectedByDevice} make
 * the errors of it that cases get. Thread-safe.
 */
final class SessionConnection implements AutoCloseable {
  /** Timeout of a call to the simulator; the agent enforces a shorter limit for a case. */
  private static final Duration CALL_TIMEOUT = Duration.ofMinutes(5);

  private static final String UNIX = "unix:";

  /** What is appended to the path of the gRPC socket. */
  private static final String OPERATIONS = ".ops";

  private final SimulatorChannel channel;
  private final CreateSessionResponse created;
  private final String session;

  /** Empty if the simulator offers none: then each operation is a unary call. */
  private final Optional<OperationSocket> operations;

  /** Why the simulator or the session is lost, so that no result counts; null while they work. */
  private volatile @Nullable SimulationException loss;

  private SessionConnection(
      SimulatorChannel channel,
      CreateSessionResponse created,
      Optional<OperationSocket> operations) {
    this.channel = channel;
    this.created = created;
    this.session = created.getSessionId();
    this.operations = operations;
  }

  /**
   * Opens a session.
   *
   * @param target where the simulator listens
   * @param worldDescription a {@code *.world.yaml}; all files of its folder belong to the world
   * @throws IOException when the world cannot be read
   */
  static SessionConnection open(String target, Path worldDescription, long seed)
      throws IOException {
    CreateSessionRequest request =
        CreateSessionRequest.newBuilder()
            .setWorld(WorldFiles.read(worldDescription))
            .setSeed(seed)
            .build();
    SimulatorChannel channel = new SimulatorChannel(target);
    try {
      CreateSessionResponse created = control(channel).createSession(request);
      if (created.getWorld().getTimestepNs() <= 0) {
        throw new SimulationException("the simulator reported no timestep");
      }
      Optional<OperationSocket> operations =
          created.getOperationSocket() && target.startsWith(UNIX)
              ? OperationSocket.open(target.substring(UNIX.length()) + OPERATIONS)
              : Optional.empty();
      return new SessionConnection(channel, created, operations);
    } catch (StatusRuntimeException e) {
      channel.close();
      throw failure("opening the world " + worldDescription.getFileName(), e);
    } catch (RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  /** What the simulator answered when the session was opened. */
  CreateSessionResponse created() {
    return created;
  }

  WorldState prepare(
      Map<String, Double> parameters, Duration settle, Duration callAfter, int caseNo) {
    PrepareRequest request =
        PrepareRequest.newBuilder()
            .setSessionId(session)
            .putAllParameters(parameters)
            .setSettleNs(settle.toNanos())
            .setCallAfterNs(callAfter.toNanos())
            .setCaseNo(caseNo)
            .build();
    return operations
        .map(socket -> socket.operate(OperateRequest.newBuilder().setPrepare(request).build()))
        .orElseGet(() -> control().prepare(request).getState());
  }

  /** Empty when the simulator rejects a case; preparing each case separately reports which one. */
  Optional<PrepareManyResponse> prepareMany(PrepareManyRequest cases) {
    PrepareManyRequest request = cases.toBuilder().setSessionId(session).build();
    try {
      return Optional.of(control().prepareMany(request));
    } catch (StatusRuntimeException e) {
      return Optional.empty();
    }
  }

  WorldState step(long steps, List<DeviceCommand> commands) {
    StepSimulationRequest request =
        StepSimulationRequest.newBuilder()
            .setSessionId(session)
            .setSteps(steps)
            .addAllCommands(commands)
            .build();
    return operations
        .map(socket -> socket.operate(OperateRequest.newBuilder().setStep(request).build()))
        .orElseGet(() -> control().stepSimulation(request).getState());
  }

  WorldState write(List<DeviceCommand> commands) {
    WriteDevicesRequest request =
        WriteDevicesRequest.newBuilder().setSessionId(session).addAllCommands(commands).build();
    return operations
        .map(socket -> socket.operate(OperateRequest.newBuilder().setWrite(request).build()))
        .orElseGet(() -> devices().writeDevices(request).getState());
  }

  Reading read(String device) {
    return devices()
        .readDevices(
            ReadDevicesRequest.newBuilder().setSessionId(session).addDevices(device).build())
        .getState()
        .getReadings(0);
  }

  WorldState set(String parameter, double value) {
    SetParametersRequest request =
        SetParametersRequest.newBuilder().setSessionId(session).putValues(parameter, value).build();
    return operations
        .map(
            socket -> socket.operate(OperateRequest.newBuilder().setSetParameters(request).build()))
        .orElseGet(() -> control().setParameters(request).getState());
  }

  RecordMotionResponse recordMotion(long frameNanos) {
    return control()
        .recordMotion(
            RecordMotionRequest.newBuilder()
                .setSessionId(session)
                .setIntervalNs(frameNanos)
                .build());
  }

  byte[] takeMotion() {
    return control()
        .takeMotion(TakeMotionRequest.newBuilder().setSessionId(session).build())
        .getGltf()
        .toByteArray();
  }

  void keepSignals(int no, long callNanos) {
    KeepSignalsResponse unused =
        control()
            .keepSignals(
                KeepSignalsRequest.newBuilder()
                    .setSessionId(session)
                    .setCaseNo(no)
                    .setCallTimeNs(callNanos)
                    .build());
  }

  void renew() {
    var unused =
        control().renewSession(RenewSessionRequest.newBuilder().setSessionId(session).build());
  }

  /** Deletes the session, unless the simulator is lost. */
  @Override
  public void close() {
    try {
      var unused =
          control().deleteSession(DeleteSessionRequest.newBuilder().setSessionId(session).build());
    } catch (StatusRuntimeException e) {
      // The session is no longer needed; its lease expires.
    } finally {
      operations.ifPresent(OperationSocket::close);
      channel.close();
    }
  }

  /**
   * Makes a call.
   *
   * @param what the caller does, for the error
   * @throws SimulationException when it fails
   */
  <T> T ask(String what, Supplier<T> call) {
    try {
      return call.get();
    } catch (StatusRuntimeException e) {
      throw lost(what, e);
    }
  }

  /**
   * The error of a call; remembers a loss of the simulator, in case the component catches the
   * exception.
   */
  SimulationException lost(String what, StatusRuntimeException e) {
    SimulationException failure = failure(what, e);
    // A component that interrupts its own thread cancels a call; the simulator is still there.
    if (isLost(e.getStatus()) && !(e.getStatus().getCause() instanceof InterruptedException)) {
      loss = failure;
    }
    return failure;
  }

  /** A command that the device rejects is an error of the component, not of the simulator. */
  RuntimeException rejectedByDevice(String what, StatusRuntimeException e) {
    return switch (e.getStatus().getCode()) {
      case INVALID_ARGUMENT, OUT_OF_RANGE ->
          new IllegalArgumentException(String.valueOf(e.getStatus().getDescription()), e);
      default -> lost(what, e);
    };
  }

  /**
   * Checks that the simulator and the session were not lost in an earlier call.
   *
   * @throws SimulationException when they were, with {@link SimulationException#isLost()}
   */
  void requireNotLost() {
    SimulationException found = loss;
    if (found != null) {
      throw new SimulationException("the simulator is gone: " + found.getMessage(), true, found);
    }
  }

  private SimulationControlBlockingStub control() {
    return control(channel);
  }

  private static SimulationControlBlockingStub control(SimulatorChannel channel) {
    return SimulationControlGrpc.newBlockingStub(channel.channel())
        .withDeadlineAfter(CALL_TIMEOUT.toSeconds(), TimeUnit.SECONDS);
  }

  private VirtualHardwareBlockingStub devices() {
    return VirtualHardwareGrpc.newBlockingStub(channel.channel())
        .withDeadlineAfter(CALL_TIMEOUT.toSeconds(), TimeUnit.SECONDS);
  }

  private static SimulationException failure(String what, StatusRuntimeException e) {
    Status status = e.getStatus();
    String reason = status.getDescription() == null ? "" : ": " + status.getDescription();
    return new SimulationException(
        "simulator: " + what + ": " + status.getCode() + reason, isLost(status), e);
  }

  private static boolean isLost(Status status) {
    return switch (status.getCode()) {
      case INVALID_ARGUMENT, OUT_OF_RANGE, DATA_LOSS, RESOURCE_EXHAUSTED, FAILED_PRECONDITION ->
          false;
      default -> true;
    };
  }
}
