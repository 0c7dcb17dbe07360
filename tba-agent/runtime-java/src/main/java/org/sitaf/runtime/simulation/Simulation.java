package org.sitaf.runtime.simulation;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.frozen.FrozenWorld;
import org.sitaf.runtime.simulation.frozen.Preparation;
import org.sitaf.runtime.suite.TestCase;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.RecordMotionResponse;
import org.sitaf.sim.v1.WorldState;

/**
 * A session of the robot simulator: prepares the virtual environment of each case and advances its
 * time. Every failure is a {@link SimulationException}.
 */
public final class Simulation implements AutoCloseable {
  /** Simulation time between two frames of a recording: 50 frames per second. */
  private static final long FRAME_NANOS = 20_000_000;

  private final SessionConnection connection;
  private final PassingTime time;
  private final SimulatedHardware hardware;
  private final Lease lease;
  private final long timestepNanos;
  private final Preparation preparation;
  private final PendingCommands pending;
  private final Object acting = new Object();
  private volatile FrozenWorld world;

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
      SessionConnection connection, Stopwatch stopwatch, IntFunction<List<TestCase>> upcoming) {
    CreateSessionResponse created = connection.created();
    this.connection = connection;
    this.timestepNanos = created.getWorld().getTimestepNs();
    this.time = new PassingTime(timestepNanos, this::step);
    this.preparation = new Preparation(created, upcoming, connection::prepareMany);
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
            connection::renew);
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
    SessionConnection connection = SessionConnection.open(target, worldDescription, seed);
    try {
      return new Simulation(connection, stopwatch, upcoming);
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
    connection.requireNotLost();
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
    RecordMotionResponse unused =
        connection.ask("recording", () -> connection.recordMotion(FRAME_NANOS));
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
    try {
      give(pending.take());
      current.save(no, connection.takeMotion());
    } catch (StatusRuntimeException e) {
      if (e.getStatus().getCode() != Status.Code.DATA_LOSS) {
        throw connection.lost("taking the recording of case " + no, e);
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
    freeze(
        connection.ask(
            "setting " + parameter + " to " + value, () -> connection.set(parameter, value)));
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
    try {
      give(pending.take());
      connection.keepSignals(no, callNanos);
    } catch (StatusRuntimeException e) {
      SimulationException lost = connection.lost("keeping the signals of case " + no, e);
      System.err.println("sitaf: " + lost.getMessage());
    }
  }

  /** Deletes the session, unless the simulator is lost. */
  @Override
  public void close() {
    lease.close();
    time.end();
    connection.close();
  }

  private void prepareSeparately(Prepared prepared) {
    freeze(
        connection.ask(
            "setting " + prepared.parameters(),
            () ->
                connection.prepare(
                    prepared.parameters(), prepared.settle(), prepared.callAfter(), caseNo)));
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
    try {
      freeze(connection.step(steps, commands));
    } catch (StatusRuntimeException e) {
      String what = "advancing by " + steps + " steps";
      throw commands.isEmpty() ? connection.lost(what, e) : connection.rejectedByDevice(what, e);
    }
  }

  /** Sends the commands that wait for the next step, so that readings show their effect. */
  private void sendPending() {
    try {
      give(pending.take());
    } catch (StatusRuntimeException e) {
      throw connection.rejectedByDevice("commanding devices", e);
    }
  }

  private void give(List<DeviceCommand> commands) {
    if (commands.isEmpty()) {
      return;
    }
    freeze(connection.write(commands));
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
        throw connection.rejectedByDevice("commanding " + command.getDevice(), e);
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
      return connection.ask("reading the camera " + camera, () -> connection.read(camera));
    }

    @Override
    public void advance(Duration time) {
      Simulation.this.advance(time);
    }
  }
}
