package org.sitaf.runtime.simulation;

import io.grpc.ManagedChannel;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.IntFunction;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.frozen.FrozenWorld;
import org.sitaf.runtime.simulation.frozen.Preparation;
import org.sitaf.runtime.suite.TestCase;
import org.sitaf.sim.v1.CreateSessionRequest;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeleteSessionRequest;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.KeepSignalsRequest;
import org.sitaf.sim.v1.KeepSignalsResponse;
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.PrepareManyResponse;
import org.sitaf.sim.v1.PrepareRequest;
import org.sitaf.sim.v1.ReadDevicesRequest;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.RecordMotionRequest;
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
 * A session of the robot simulator: prepares the virtual environment of each case and advances its
 * time. Every failure is a {@link SimulationException}.
 */
public final class Simulation implements AutoCloseable {
  /** Timeout of a call to the simulator; the agent enforces a shorter limit for a case. */
  private static final Duration CALL_TIMEOUT = Duration.ofMinutes(5);

  /** Simulation time between two frames of a recording: 50 frames per second. */
  private static final long FRAME_NANOS = 20_000_000;

  private final SimulatorChannel connection;
  private final ManagedChannel channel;
  private final String session;
  private final PassingTime time;
  private final SimulatedHardware hardware;
  private final Lease lease;
  private final long timestepNanos;
  private final Preparation preparation;
  private final PendingCommands pending;
  private final Object acting = new Object();
  private volatile FrozenWorld world;

  /** Why the simulator or the session is lost, so that no result counts; null while they work. */
  private volatile @Nullable SimulationException loss;

  /** The case that the session itself still has to prepare; set while readings come in bulk. */
  private @Nullable Prepared pendingPreparation;

  private @Nullable Recording recording;

  /** Whether the simulator samples signals for the agent. */
  private final boolean keepsSignals;

  private volatile long callNanos;
  private volatile LongConsumer beforeStep = now -> {};
  private volatile int caseNo;
  private volatile boolean called;

  /** How a case is prepared. */
  private record Prepared(Map<String, Double> parameters, Duration settle, Duration callAfter) {}

  private Simulation(
      SimulatorChannel connection,
      CreateSessionResponse created,
      Stopwatch stopwatch,
      IntFunction<List<TestCase>> upcoming) {
    this.connection = connection;
    this.channel = connection.channel();
    this.session = created.getSessionId();
    this.timestepNanos = created.getWorld().getTimestepNs();
    this.time = new PassingTime(timestepNanos, this::step);
    this.preparation = new Preparation(created, upcoming, this::prepareMany);
    this.world = FrozenWorld.of(created.getState());
    this.pending = new PendingCommands(created.getWorld());
    this.keepsSignals = created.getKeepsSignals();
    if (keepsSignals) {
      // Worlds that are prepared in bulk have no signals.
      preparation.stop();
    }
    Map<String, String> kinds = new HashMap<>();
    created.getWorld().getDevicesList().forEach(d -> kinds.put(d.getName(), d.getKind()));
    this.hardware = new SimulatedHardware(kinds, stopwatch, world, new Wire());
    this.lease =
        new Lease(
            Duration.ofSeconds(created.getLease().getSeconds(), created.getLease().getNanos()),
            this::renew);
  }

  /**
   * Opens a session.
   *
   * @param target where the simulator listens: {@code 127.0.0.1:PORT} or {@code
   *     unix:/absolute/path}
   * @param worldDescription a {@code *.world.yaml}; all files of its folder belong to the world
   * @param seed seed of all random values in the simulation
   * @param stopwatch measures the time that components spend in the hardware
   * @param upcoming returns up to a number of cases after the current one, to prepare them in
   *     advance
   * @throws IOException when the world cannot be read
   */
  public static Simulation open(
      String target,
      Path worldDescription,
      long seed,
      Stopwatch stopwatch,
      IntFunction<List<TestCase>> upcoming)
      throws IOException {
    CreateSessionRequest request =
        CreateSessionRequest.newBuilder()
            .setWorld(WorldFiles.read(worldDescription))
            .setSeed(seed)
            .build();
    SimulatorChannel connection = new SimulatorChannel(target);
    try {
      CreateSessionResponse created =
          callOrThrow(
              "opening the world " + worldDescription.getFileName(),
              () -> stub(connection.channel()).createSession(request));
      if (created.getWorld().getTimestepNs() <= 0) {
        throw new SimulationException("the simulator reported no timestep");
      }
      return new Simulation(connection, created, stopwatch, upcoming);
    } catch (RuntimeException e) {
      connection.close();
      throw e;
    }
  }

  /** The hardware for the component under test. */
  public Hardware hardware() {
    return hardware;
  }

  /**
   * Prepares a case from a reset. As long as components only read, the following cases are prepared
   * in the same call. Once a component commands its hardware or waits, the session is brought to
   * the current case, and each later case is prepared separately, with the same result.
   *
   * @param parameters in the unit of each parameter of the world; others get their default
   * @param settle simulation time that passes after the parameters are set
   */
  public void prepare(Map<String, Double> parameters, Duration settle) {
    prepare(parameters, settle, Duration.ZERO);
  }

  /**
   * As {@link #prepare(Map, Duration)}, with a call that begins later.
   *
   * @param callAfter simulation time between the end of settling and the call, from which the
   *     onsets of faults count
   */
  public void prepare(Map<String, Double> parameters, Duration settle, Duration callAfter) {
    Prepared current = new Prepared(parameters, settle, callAfter);
    synchronized (acting) {
      // The reset would undo them.
      List<DeviceCommand> unused = pending.take();
      pendingPreparation = null;
      // Worlds in bulk show faults as if the call began now.
      Optional<FrozenWorld> known =
          callAfter.isZero()
              ? preparation.world(
                  parameters, settle.toNanos(), time.stepsIn(settle) * timestepNanos)
              : Optional.empty();
      if (known.isPresent()) {
        pendingPreparation = current;
        show(known.get());
      } else {
        prepareSeparately(current);
      }
    }
    time.restart(settle);
  }

  /**
   * Lets simulation time pass, rounded up to whole steps. Threads other than the one that prepared
   * the case only wait for it to pass.
   */
  public void advance(Duration duration) {
    time.pass(duration);
  }

  /** Limits the simulation time of each case; a case that exceeds it is an ERROR. */
  public void limit(Duration ofCase) {
    time.limit(ofCase);
  }

  /**
   * Calls a periodic component until the next case is prepared: at the first step at or after each
   * period from now. A tick that itself lets time pass is not called again meanwhile; the ticks in
   * that time are skipped. An exception of a tick is thrown by the call that let time pass.
   */
  public void every(Duration period, Tick tick) {
    time.every(period, tick);
  }

  /**
   * Checks that the simulator and the session were not lost in an earlier call.
   *
   * @throws SimulationException when they were, with {@link SimulationException#isLost()}
   */
  public void requireNotLost() {
    SimulationException found = loss;
    if (found != null) {
      throw new SimulationException("the simulator is gone: " + found.getMessage(), true, found);
    }
  }

  /** The simulation time of this session. */
  public PassingTime time() {
    return time;
  }

  /** The value of an observation at the current step, in the unit that the world declares. */
  public double observation(String name) {
    sendPending();
    Double value = world.observations().get(name);
    if (value == null) {
      throw new SimulationException(
          "the world has no observation '" + name + "'; it has " + world.observations().keySet());
    }
    return value;
  }

  /**
   * Starts to record the motion in each case, for {@link #saveMotion}.
   *
   * @param folder folder for the files; it is created
   * @throws IOException when it cannot be created
   */
  public void record(Path folder) throws IOException {
    recording = new Recording(folder);
    preparation.stop();
    RecordMotionRequest request =
        RecordMotionRequest.newBuilder().setSessionId(session).setIntervalNs(FRAME_NANOS).build();
    ask("recording", () -> stub(channel).recordMotion(request));
  }

  /**
   * Saves the motion since the case was prepared as {@code NO.glb} in the folder: self-contained
   * binary glTF. Does nothing when the session is not recorded, the folder is full (64 MiB), or the
   * simulation diverged.
   *
   * @param no number of the case
   * @throws IOException when it cannot be written
   */
  public void saveMotion(int no) throws IOException {
    Recording current = recording;
    if (current == null || current.isFull()) {
      return;
    }
    TakeMotionRequest request = TakeMotionRequest.newBuilder().setSessionId(session).build();
    try {
      give(pending.take());
      current.save(no, stub(channel).takeMotion(request).getGltf().toByteArray());
    } catch (StatusRuntimeException e) {
      if (e.getStatus().getCode() != Status.Code.DATA_LOSS) {
        throw rememberLoss(failure("taking the recording of case " + no, e), e);
      }
    }
  }

  /** A case begins, which the simulator notes when it is prepared. */
  public void caseBegins(int no) {
    caseNo = no;
    called = false;
  }

  /** The call under test begins now. Only the first one of a case counts. */
  public void callBegins() {
    if (!called) {
      called = true;
      callNanos = world.timeNanos();
    }
  }

  /** Calls {@code look} with the {@link #nowNanos() time} whenever it is about to pass. */
  public void beforeTimePasses(LongConsumer look) {
    beforeStep = look;
  }

  /** Simulation time, also of the settling. */
  public long nowNanos() {
    return world.timeNanos();
  }

  /** Simulation time in nanoseconds since the first call of the case. */
  public long sinceCall() {
    return world.timeNanos() - callNanos;
  }

  /**
   * Sets a parameter of the world in the running case.
   *
   * @param value in the unit of the parameter
   */
  public void set(String parameter, double value) {
    updateSession();
    sendPending();
    SetParametersRequest request =
        SetParametersRequest.newBuilder().setSessionId(session).putValues(parameter, value).build();
    freeze(
        ask(
            "setting " + parameter + " to " + value,
            () -> stub(channel).setParameters(request).getState()));
  }

  /**
   * Lets the simulator keep the signals of the current case for the agent, if the agent wants
   * signals. A failure is reported by the agent, which misses the signals.
   *
   * @param no number of the case
   */
  public void keepSignals(int no) {
    if (!keepsSignals) {
      return;
    }
    KeepSignalsRequest request =
        KeepSignalsRequest.newBuilder()
            .setSessionId(session)
            .setCaseNo(no)
            .setCallTimeNs(callNanos)
            .build();
    try {
      give(pending.take());
      KeepSignalsResponse unused = stub(channel).keepSignals(request);
    } catch (StatusRuntimeException e) {
      SimulationException remembered =
          rememberLoss(failure("keeping the signals of case " + no, e), e);
      System.err.println("sitaf: " + remembered.getMessage());
    }
  }

  /** Deletes the session, unless the simulator is lost. */
  @Override
  public void close() {
    lease.close();
    time.end();
    try {
      stub(channel).deleteSession(DeleteSessionRequest.newBuilder().setSessionId(session).build());
    } catch (StatusRuntimeException e) {
      // The session is no longer needed; its lease expires.
    } finally {
      connection.close();
    }
  }

  private void prepareSeparately(Prepared prepared) {
    PrepareRequest request =
        PrepareRequest.newBuilder()
            .setSessionId(session)
            .putAllParameters(prepared.parameters())
            .setSettleNs(prepared.settle().toNanos())
            .setCallAfterNs(prepared.callAfter().toNanos())
            .setCaseNo(caseNo)
            .build();
    freeze(
        ask("setting " + prepared.parameters(), () -> stub(channel).prepare(request).getState()));
  }

  /** Empty when the simulator rejects a case; preparing each case separately reports which one. */
  private Optional<PrepareManyResponse> prepareMany(PrepareManyRequest cases) {
    PrepareManyRequest request = cases.toBuilder().setSessionId(session).build();
    try {
      return Optional.of(stub(channel).prepareMany(request));
    } catch (StatusRuntimeException e) {
      return Optional.empty();
    }
  }

  /** Brings the session to the state that the readings of the current case show. */
  private void updateSession() {
    synchronized (acting) {
      Prepared current = pendingPreparation;
      if (current != null) {
        pendingPreparation = null;
        preparation.stop();
        prepareSeparately(current);
      }
    }
  }

  private void step(long steps) {
    beforeStep.accept(world.timeNanos());
    updateSession();
    List<DeviceCommand> commands = pending.take();
    StepSimulationRequest request =
        StepSimulationRequest.newBuilder()
            .setSessionId(session)
            .setSteps(steps)
            .addAllCommands(commands)
            .build();
    try {
      freeze(stub(channel).stepSimulation(request).getState());
    } catch (StatusRuntimeException e) {
      String what = "advancing by " + steps + " steps";
      throw commands.isEmpty() ? rememberLoss(failure(what, e), e) : rejectedByDevice(what, e);
    }
  }

  /** Sends the commands that wait for the next step, so that readings show their effect. */
  private void sendPending() {
    try {
      give(pending.take());
    } catch (StatusRuntimeException e) {
      throw rejectedByDevice("commanding devices", e);
    }
  }

  private void give(List<DeviceCommand> commands) {
    if (commands.isEmpty()) {
      return;
    }
    WriteDevicesRequest request =
        WriteDevicesRequest.newBuilder().setSessionId(session).addAllCommands(commands).build();
    freeze(devices(channel).writeDevices(request).getState());
  }

  private void renew() {
    stub(channel).renewSession(RenewSessionRequest.newBuilder().setSessionId(session).build());
  }

  private void freeze(WorldState state) {
    show(FrozenWorld.of(state));
  }

  private void show(FrozenWorld shown) {
    world = shown;
    hardware.freeze(shown);
  }

  /** Calls of devices to the simulator. */
  private final class Wire implements SimulatedHardware.Simulator {
    @Override
    public void write(DeviceCommand command) {
      updateSession();
      if (pending.isAcceptable(command)) {
        if (pending.isFull()) {
          sendPending();
        }
        pending.add(command);
        return;
      }
      sendPending();
      try {
        give(List.of(command));
      } catch (StatusRuntimeException e) {
        throw rejectedByDevice("commanding " + command.getDevice(), e);
      }
    }

    @Override
    public void sendPending() {
      Simulation.this.sendPending();
    }

    @Override
    public Reading look(String camera) {
      updateSession();
      sendPending();
      ReadDevicesRequest request =
          ReadDevicesRequest.newBuilder().setSessionId(session).addDevices(camera).build();
      return ask(
          "reading the camera " + camera,
          () -> devices(channel).readDevices(request).getState().getReadings(0));
    }

    @Override
    public void advance(Duration time) {
      Simulation.this.advance(time);
    }
  }

  /** A command that the device rejects is an error of the component, not of the simulator. */
  private RuntimeException rejectedByDevice(String what, StatusRuntimeException e) {
    return switch (e.getStatus().getCode()) {
      case INVALID_ARGUMENT, OUT_OF_RANGE ->
          new IllegalArgumentException(String.valueOf(e.getStatus().getDescription()), e);
      default -> rememberLoss(failure(what, e), e);
    };
  }

  private static SimulationControlBlockingStub stub(ManagedChannel channel) {
    return SimulationControlGrpc.newBlockingStub(channel)
        .withDeadlineAfter(CALL_TIMEOUT.toSeconds(), TimeUnit.SECONDS);
  }

  private static VirtualHardwareBlockingStub devices(ManagedChannel channel) {
    return VirtualHardwareGrpc.newBlockingStub(channel)
        .withDeadlineAfter(CALL_TIMEOUT.toSeconds(), TimeUnit.SECONDS);
  }

  private <T> T ask(String what, Supplier<T> call) {
    try {
      return call.get();
    } catch (StatusRuntimeException e) {
      throw rememberLoss(failure(what, e), e);
    }
  }

  private static <T> T callOrThrow(String what, Supplier<T> call) {
    try {
      return call.get();
    } catch (StatusRuntimeException e) {
      throw failure(what, e);
    }
  }

  /** Remembers a loss of the simulator, in case the component catches the exception. */
  private SimulationException rememberLoss(SimulationException failure, StatusRuntimeException e) {
    // A component that interrupts its own thread cancels a call; the simulator is still there.
    if (isLost(e.getStatus()) && !(e.getStatus().getCause() instanceof InterruptedException)) {
      loss = failure;
    }
    return failure;
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
