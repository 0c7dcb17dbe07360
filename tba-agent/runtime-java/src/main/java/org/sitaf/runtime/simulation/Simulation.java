package org.sitaf.runtime.simulation;

import io.grpc.Grpc;
import io.grpc.InsecureChannelCredentials;
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
import java.util.function.Supplier;
import java.util.logging.Level;
import java.util.logging.Logger;
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
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.PrepareManyResponse;
import org.sitaf.sim.v1.PrepareRequest;
import org.sitaf.sim.v1.ReadDevicesRequest;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.RecordMotionRequest;
import org.sitaf.sim.v1.RenewSessionRequest;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.SimulationControlGrpc.SimulationControlBlockingStub;
import org.sitaf.sim.v1.StepSimulationRequest;
import org.sitaf.sim.v1.TakeMotionRequest;
import org.sitaf.sim.v1.VirtualHardwareGrpc;
import org.sitaf.sim.v1.VirtualHardwareGrpc.VirtualHardwareBlockingStub;
import org.sitaf.sim.v1.WorldState;
import org.sitaf.sim.v1.WriteDevicesRequest;

/**
 * One session of the robot simulator: sets the virtual environment of a case and moves its time.
 * Every failure is a {@link SimulationException}.
 */
public final class Simulation implements AutoCloseable {
  /** Longest wait for one answer; a case has its own, shorter limit, which the agent watches. */
  private static final Duration LONGEST_CALL = Duration.ofMinutes(5);

  private static final int MAX_MESSAGE_BYTES = 64 << 20;

  /** Simulation time between two frames of a recording: 50 a second. */
  private static final long FRAME_NANOS = 20_000_000;

  /**
   * Netty warns on every Unix socket that it has no keep-alive; the tester's log is not the place
   * for it. The field keeps the logger, which would lose its level when collected.
   */
  private static final Logger SOCKET_OPTIONS =
      Logger.getLogger("io.grpc.netty.shaded.io.netty.bootstrap");

  private final ManagedChannel channel;
  private final String session;
  private final PassingTime time;
  private final SimulatedHardware hardware;
  private final Lease lease;
  private final long timestepNanos;
  private final Preparation preparation;
  private final Object acting = new Object();
  private volatile FrozenWorld world;

  /** Why no result can be trusted any more; null while the simulator and the session are there. */
  private volatile @Nullable SimulationException gone;

  /** Set while the session itself lags behind the readings, which came in bulk. */
  private @Nullable Prepared behind;

  private @Nullable Recording recording;

  /** How a case is prepared. */
  private record Prepared(Map<String, Double> parameters, Duration settle) {}

  private Simulation(
      ManagedChannel channel,
      CreateSessionResponse created,
      Stopwatch stopwatch,
      IntFunction<List<TestCase>> coming) {
    this.channel = channel;
    this.session = created.getSessionId();
    this.timestepNanos = created.getWorld().getTimestepNs();
    this.time = new PassingTime(timestepNanos, this::step);
    this.preparation = new Preparation(created, coming, this::prepareMany);
    this.world = FrozenWorld.of(created.getState());
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
   * @param worldDescription a {@code *.world.yaml}; the world's files are all files of its folder
   * @param seed of everything random in the simulation
   * @param stopwatch counts what components spend in the hardware
   * @param coming gives up to so many of the cases after the current one, to be prepared with it
   * @throws IOException when the world cannot be read
   */
  public static Simulation open(
      String target,
      Path worldDescription,
      long seed,
      Stopwatch stopwatch,
      IntFunction<List<TestCase>> coming)
      throws IOException {
    CreateSessionRequest request =
        CreateSessionRequest.newBuilder()
            .setWorld(WorldFiles.read(worldDescription))
            .setSeed(seed)
            .build();
    SOCKET_OPTIONS.setLevel(Level.SEVERE);
    ManagedChannel channel =
        Grpc.newChannelBuilder(target, InsecureChannelCredentials.create())
            .proxyDetector(address -> null)
            .maxInboundMessageSize(MAX_MESSAGE_BYTES)
            .directExecutor()
            .build();
    try {
      CreateSessionResponse created =
          asked(
              "opening the world " + worldDescription.getFileName(),
              () -> stub(channel).createSession(request));
      if (created.getWorld().getTimestepNs() <= 0) {
        throw new SimulationException("the simulator names no length of a step");
      }
      return new Simulation(channel, created, stopwatch, coming);
    } catch (RuntimeException e) {
      channel.shutdownNow();
      throw e;
    }
  }

  /** What a component under test gets. */
  public Hardware hardware() {
    return hardware;
  }

  /**
   * Prepares a case from a clean reset. Coming cases are prepared at the same time, as long as the
   * component only reads; one that commands its hardware or waits finds the session live, and from
   * then on each case is prepared alone, with the same result.
   *
   * @param parameters in the unit of each parameter of the world; those not named take their
   *     default
   * @param settle simulation time that passes afterwards
   */
  public void prepare(Map<String, Double> parameters, Duration settle) {
    Prepared current = new Prepared(parameters, settle);
    synchronized (acting) {
      behind = null;
      Optional<FrozenWorld> known =
          preparation.world(parameters, settle.toNanos(), time.stepsIn(settle) * timestepNanos);
      if (known.isPresent()) {
        behind = current;
        show(known.get());
      } else {
        prepareAlone(current);
      }
    }
    time.restart(settle);
  }

  /**
   * Lets simulation time pass, rounded up to whole steps. In other threads than the one that
   * prepared the case it only waits for time to pass.
   */
  public void advance(Duration duration) {
    time.pass(duration);
  }

  /** Bounds the simulation time that one case may take; it is an error to go beyond. */
  public void limit(Duration ofCase) {
    time.limit(ofCase);
  }

  /**
   * Calls a periodic component while time passes, until the next case is prepared: after the step
   * that ends at or first after each whole period from now. A tick that lets time pass itself is
   * not called meanwhile, and skips what it slept through. What a tick throws comes out of the call
   * that let time pass.
   */
  public void every(Duration period, Tick tick) {
    time.every(period, tick);
  }

  /**
   * Requires that nothing found the simulator or the session gone.
   *
   * @throws SimulationException which {@link SimulationException#isLost() is lost}
   */
  public void requireThere() {
    SimulationException found = gone;
    if (found != null) {
      throw new SimulationException("the simulator is gone: " + found.getMessage(), true, found);
    }
  }

  /** How the time of this session passes for threads that wait for it. */
  public PassingTime time() {
    return time;
  }

  /** What the world shows at the current step, in the unit that the world declares. */
  public double observation(String name) {
    Double value = world.observations().get(name);
    if (value == null) {
      throw new SimulationException(
          "the world has no observation '" + name + "'; it has " + world.observations().keySet());
    }
    return value;
  }

  /**
   * Records from now on what moves, for {@link #saveMotion}.
   *
   * @param folder where the files go; it is made
   * @throws IOException when it cannot be made
   */
  public void record(Path folder) throws IOException {
    recording = new Recording(folder);
    preparation.stop();
    RecordMotionRequest request =
        RecordMotionRequest.newBuilder().setSessionId(session).setIntervalNs(FRAME_NANOS).build();
    ask("recording", () -> stub(channel).recordMotion(request));
  }

  /**
   * Saves what moved since the case was prepared, as the file {@code NO.glb} of the folder: binary
   * glTF, complete in itself. Does nothing where nothing is recorded, the folder holds 64 MiB, or
   * the simulation diverged.
   *
   * @param no number of the case
   * @throws IOException when it cannot be written
   */
  public void saveMotion(int no) throws IOException {
    Recording films = recording;
    if (films == null || films.isFull()) {
      return;
    }
    TakeMotionRequest request = TakeMotionRequest.newBuilder().setSessionId(session).build();
    try {
      films.save(no, stub(channel).takeMotion(request).getGltf().toByteArray());
    } catch (StatusRuntimeException e) {
      if (e.getStatus().getCode() != Status.Code.DATA_LOSS) {
        throw noted(failure("taking the recording of case " + no, e), e);
      }
    }
  }

  /** Frees the session; a lost simulator has already done so. */
  @Override
  public void close() {
    lease.close();
    time.end();
    try {
      stub(channel).deleteSession(DeleteSessionRequest.newBuilder().setSessionId(session).build());
    } catch (StatusRuntimeException e) {
      // Nothing of it is needed any more.
    } finally {
      channel.shutdownNow();
    }
  }

  private void prepareAlone(Prepared prepared) {
    PrepareRequest request =
        PrepareRequest.newBuilder()
            .setSessionId(session)
            .putAllParameters(prepared.parameters())
            .setSettleNs(prepared.settle().toNanos())
            .build();
    freeze(
        ask("setting " + prepared.parameters(), () -> stub(channel).prepare(request).getState()));
  }

  /** A refusal names no single case; the session tells of each when it prepares it alone. */
  private Optional<PrepareManyResponse> prepareMany(PrepareManyRequest cases) {
    PrepareManyRequest request = cases.toBuilder().setSessionId(session).build();
    try {
      return Optional.of(stub(channel).prepareMany(request));
    } catch (StatusRuntimeException e) {
      return Optional.empty();
    }
  }

  /** Brings the session to where the readings of the current case are from. */
  private void goLive() {
    synchronized (acting) {
      Prepared current = behind;
      if (current != null) {
        behind = null;
        preparation.stop();
        prepareAlone(current);
      }
    }
  }

  private void step(long steps) {
    goLive();
    StepSimulationRequest request =
        StepSimulationRequest.newBuilder().setSessionId(session).setSteps(steps).build();
    freeze(
        ask(
            "advancing by " + steps + " steps",
            () -> stub(channel).stepSimulation(request).getState()));
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

  /** What devices ask of the simulator. */
  private final class Wire implements SimulatedHardware.Simulator {
    @Override
    public void write(DeviceCommand command) {
      goLive();
      WriteDevicesRequest request =
          WriteDevicesRequest.newBuilder().setSessionId(session).addCommands(command).build();
      try {
        freeze(devices().writeDevices(request).getState());
      } catch (StatusRuntimeException e) {
        throw refusedByDevice(command.getDevice(), e);
      }
    }

    @Override
    public Reading look(String camera) {
      goLive();
      ReadDevicesRequest request =
          ReadDevicesRequest.newBuilder().setSessionId(session).addDevices(camera).build();
      return ask(
          "looking through " + camera,
          () -> devices().readDevices(request).getState().getReadings(0));
    }

    @Override
    public void advance(Duration time) {
      Simulation.this.advance(time);
    }

    private VirtualHardwareBlockingStub devices() {
      return VirtualHardwareGrpc.newBlockingStub(channel)
          .withDeadlineAfter(LONGEST_CALL.toSeconds(), TimeUnit.SECONDS);
    }
  }

  /** A command that the device does not take is the component's doing, not the simulator's. */
  private RuntimeException refusedByDevice(String device, StatusRuntimeException e) {
    return switch (e.getStatus().getCode()) {
      case INVALID_ARGUMENT, OUT_OF_RANGE ->
          new IllegalArgumentException(String.valueOf(e.getStatus().getDescription()), e);
      default -> noted(failure("commanding " + device, e), e);
    };
  }

  private static SimulationControlBlockingStub stub(ManagedChannel channel) {
    return SimulationControlGrpc.newBlockingStub(channel)
        .withDeadlineAfter(LONGEST_CALL.toSeconds(), TimeUnit.SECONDS);
  }

  private <T> T ask(String what, Supplier<T> call) {
    try {
      return call.get();
    } catch (StatusRuntimeException e) {
      throw noted(failure(what, e), e);
    }
  }

  private static <T> T asked(String what, Supplier<T> call) {
    try {
      return call.get();
    } catch (StatusRuntimeException e) {
      throw failure(what, e);
    }
  }

  /** Whatever the component makes of the failure, the case is not measured. */
  private SimulationException noted(SimulationException failure, StatusRuntimeException e) {
    Status.Code code = e.getStatus().getCode();
    if (code == Status.Code.UNAVAILABLE || code == Status.Code.NOT_FOUND) {
      gone = failure;
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
