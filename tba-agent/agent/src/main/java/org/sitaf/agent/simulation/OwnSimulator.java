package org.sitaf.agent.simulation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.core.digest.Sha256;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.HardwareReport;

/** A bridge that serves one build; replaced by a new one if it dies. */
final class OwnSimulator implements BuildSimulator {
  private static final int MAX_ATTEMPTS = 2;

  private final BridgePool bridges;
  private @Nullable BridgeProcess bridge;
  private @Nullable World world;
  private @Nullable SignalOrder signals;
  private @Nullable HardwareOrder hardware;
  private @Nullable HardwareGuard guard;
  private List<String> served = List.of();
  private int endpoints;

  /** Endpoints that are not closed, also of bridges that ended. */
  private final Set<Endpoint> open = ConcurrentHashMap.newKeySet();

  private boolean closed;

  /** The files of the build's world, and what bridges know of it. */
  private record World(String description, Map<String, byte[]> files, CompiledWorld compiled) {}

  OwnSimulator(BridgePool bridges) {
    this.bridges = bridges;
  }

  @Override
  public String description() {
    Sandbox sandbox = bridges.sandbox();
    return "the simulator serves this build only"
        + (sandbox.kind().equals(Sandbox.NONE)
            ? ""
            : ", in a sandbox with at most " + BridgeProcess.LIMITS.memoryMiB() + " MiB of memory");
  }

  @Override
  public synchronized String version() throws SimulatorException, InterruptedException {
    return runningBridge().client().version();
  }

  @Override
  public synchronized String target() throws SimulatorException, InterruptedException {
    return runningBridge().target();
  }

  @Override
  public synchronized long check(String description, Map<String, byte[]> files, Set<String> faults)
      throws WorldException, SimulatorException, InterruptedException {
    String key = keyOf(description, files);
    Optional<CompiledWorld> known = bridges.acceptedWorld(key);
    // What fits a known world is not known of these faults.
    if (known.isPresent() && faults.isEmpty()) {
      world = new World(description, Map.copyOf(files), known.get());
      compileInBackground(runningBridge(), world);
      return known.get().stepNanos();
    }
    CompiledWorld compiled = compile(description, files, faults);
    bridges.addAccepted(key, compiled);
    world = new World(description, Map.copyOf(files), compiled);
    return compiled.stepNanos();
  }

  /** Retries once: a world that ends the bridge every time is at fault. */
  private CompiledWorld compile(String description, Map<String, byte[]> files, Set<String> faults)
      throws WorldException, SimulatorException, InterruptedException {
    for (int attempt = 1; ; attempt++) {
      BridgeProcess current = runningBridge();
      try {
        return current.client().check(description, files, faults);
      } catch (SimulatorException e) {
        Optional<SimulatorEnd> end = current.end();
        if (end.isEmpty()) {
          throw e;
        }
        if (end.get().byLimit() || attempt == MAX_ATTEMPTS) {
          throw new WorldException(
              "compiling it ended the simulator: "
                  + end.get().reason()
                  + "; make the world smaller");
        }
      }
    }
  }

  /** Lets the bridge compile a known world while the test application is compiled. */
  private static void compileInBackground(BridgeProcess bridge, World world) {
    Thread thread =
        new Thread(
            () -> {
              try {
                bridge.client().check(world.description(), world.files(), Set.of());
              } catch (WorldException | SimulatorException e) {
                // The session that needs the world reports the error.
              }
            },
            "sitaf-world");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public synchronized void sample(SignalOrder order) {
    signals = order;
  }

  @Override
  public Optional<Trace> takeSignals(int no) throws SimulatorException {
    for (Endpoint endpoint : open) {
      if (endpoint.hasEnded()) {
        continue;
      }
      Optional<Trace> trace = endpoint.bridge().client().takeSignals(endpoint.name(), no);
      if (trace.isPresent()) {
        return trace;
      }
    }
    return Optional.empty();
  }

  @Override
  public Optional<LiveMotion.Motion> motion(long known) throws SimulatorException {
    for (Endpoint endpoint : open) {
      if (!endpoint.hasEnded()) {
        Optional<LiveMotion.Motion> motion =
            endpoint.bridge().client().motion(endpoint.name(), known);
        if (motion.isPresent()) {
          return motion;
        }
      }
    }
    return Optional.empty();
  }

  @Override
  public synchronized SimulatorEndpoint open() throws SimulatorException, InterruptedException {
    World offered = world;
    if (offered == null) {
      throw new IllegalStateException("the world was not checked");
    }
    for (int attempt = 1; ; attempt++) {
      BridgeProcess current = runningBridge();
      String name = "e" + ++endpoints;
      try {
        String unused =
            current
                .client()
                .openEndpoint(name, offered.compiled().digest(), signals, hardwareOf(current));
        Endpoint opened = new Endpoint(current, name, current.share(name), open);
        open.add(opened);
        return opened;
      } catch (IOException e) {
        boolean ended = current.end().isPresent();
        if (!ended || attempt == MAX_ATTEMPTS) {
          throw new SimulatorException(
              "the simulator cannot open an endpoint: " + e.getMessage(), e);
        }
      }
    }
  }

  @Override
  public synchronized List<String> use(HardwareOrder order)
      throws WorldException, SimulatorException, InterruptedException {
    World checked = world;
    if (checked == null) {
      throw new IllegalStateException("the world was not checked");
    }
    if (order.hasRealDevices()) {
      guard = bridges.startGuard(order.guardFile(checked.compiled().commands()));
    }
    hardware = order;
    BridgeProcess current = runningBridge();
    try {
      served =
          current
              .client()
              .checkHardware(
                  checked.description(),
                  checked.files(),
                  Objects.requireNonNull(hardwareOf(current)),
                  order.parameters());
    } catch (IOException e) {
      throw new SimulatorException("the simulator cannot reach the devices: " + e.getMessage(), e);
    }
    return served;
  }

  /** What a bridge must know of the devices; null if all are simulated. */
  private org.sitaf.sim.v1.@Nullable HardwareOrder hardwareOf(BridgeProcess current)
      throws IOException {
    HardwareOrder order = hardware;
    HardwareGuard guarding = guard;
    if (order == null) {
      return null;
    }
    return order.message(guarding == null ? "" : current.admit(guarding.socket()));
  }

  @Override
  public @Nullable HardwareReport takeHardwareReport(int no) throws SimulatorException {
    if (hardware == null) {
      return null;
    }
    HardwareReport merged = null;
    for (Endpoint endpoint : open) {
      if (!endpoint.hasEnded()) {
        HardwareReport report =
            HardwareReports.of(
                endpoint.bridge().client().takeHardwareReport(endpoint.name(), no), served);
        if (merged == null || report.exchanges() + report.readings() > 0) {
          merged = report;
        }
      }
    }
    if (merged == null) {
      throw new SimulatorException("the simulator has ended");
    }
    HardwareGuard guarding = guard;
    return guarding != null && !guarding.isAlive()
        ? HardwareReports.withFault(merged, "the hardware guard has ended")
        : merged;
  }

  /** The bridge, or a new one if it has died. */
  private BridgeProcess runningBridge() throws SimulatorException, InterruptedException {
    if (closed) {
      throw new SimulatorException("the build has ended");
    }
    BridgeProcess current = bridge;
    if (current != null && current.isAlive()) {
      return current;
    }
    if (current != null) {
      current.close();
    }
    current = bridges.take();
    bridge = current;
    bridges.startNext();
    return current;
  }

  private static String keyOf(String description, Map<String, byte[]> files) {
    StringBuilder key = new StringBuilder(description);
    new TreeMap<>(files)
        .forEach(
            (path, content) ->
                key.append('\0').append(path).append('\0').append(Sha256.hex(content)));
    return Sha256.hex(key.toString().getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (bridge != null) {
      bridge.close();
      bridge = null;
      bridges.startAhead();
    }
    HardwareGuard guarding = guard;
    if (guarding != null) {
      guard = null;
      guarding.close();
    }
  }

  /** A socket of the bridge for one process of the test application. */
  private record Endpoint(BridgeProcess bridge, String name, Path socket, Set<Endpoint> open)
      implements SimulatorEndpoint {
    @Override
    public boolean equals(@Nullable Object other) {
      return this == other;
    }

    @Override
    public int hashCode() {
      return name.hashCode();
    }

    @Override
    public String target() {
      return "unix:" + socket;
    }

    @Override
    public boolean isShared() {
      return false;
    }

    @Override
    public boolean hasEnded() {
      return !bridge.isAlive();
    }

    @Override
    public Optional<SimulatorEnd> end() throws InterruptedException {
      return bridge.end();
    }

    @Override
    public void stopDevices() {
      bridge.client().stopHardware(name);
    }

    @Override
    public void close() {
      open.remove(this);
      bridge.closeEndpoint(name);
    }
  }
}
