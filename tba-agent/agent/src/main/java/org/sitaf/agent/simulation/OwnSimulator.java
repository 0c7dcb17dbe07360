package org.sitaf.agent.simulation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;

/** A bridge that serves one build; one that died is followed by a fresh one. */
final class OwnSimulator implements BuildSimulator {
  private static final int STARTS = 2;

  private final StartedSimulator bridges;
  private @Nullable BridgeProcess bridge;
  private @Nullable World world;
  private int endpoints;
  private boolean closed;

  /** The build's world: its files, and their digest as bridges compute it. */
  private record World(String description, Map<String, byte[]> files, String digest) {}

  OwnSimulator(StartedSimulator bridges) {
    this.bridges = bridges;
  }

  @Override
  public String description() {
    Sandbox sandbox = bridges.sandbox();
    return "the simulator is this build's alone"
        + (sandbox.kind().equals(Sandbox.NONE)
            ? ""
            : ", in a sandbox with at most " + BridgeProcess.LIMITS.memoryMiB() + " MiB of memory");
  }

  @Override
  public synchronized String version() throws SimulatorException, InterruptedException {
    return living().client().version();
  }

  @Override
  public synchronized String target() throws SimulatorException, InterruptedException {
    return living().target();
  }

  @Override
  public synchronized void check(String description, Map<String, byte[]> files)
      throws WorldException, SimulatorException, InterruptedException {
    String key = keyOf(description, files);
    Optional<String> known = bridges.digestOf(key);
    if (known.isPresent()) {
      world = new World(description, Map.copyOf(files), known.get());
      compileMeanwhile(living(), world);
      return;
    }
    String digest = compiled(description, files);
    bridges.accepted(key, digest);
    world = new World(description, Map.copyOf(files), digest);
  }

  /** A world that ends the bridge each time is at fault; once may be bad luck of the machine. */
  private String compiled(String description, Map<String, byte[]> files)
      throws WorldException, SimulatorException, InterruptedException {
    for (int start = 1; ; start++) {
      BridgeProcess used = living();
      try {
        return used.client().check(description, files);
      } catch (SimulatorException e) {
        Optional<SimulatorEnd> end = used.end();
        if (end.isEmpty()) {
          throw e;
        }
        if (end.get().byLimit() || start == STARTS) {
          throw new WorldException(
              "compiling it ended the simulator: "
                  + end.get().reason()
                  + "; make the world smaller");
        }
      }
    }
  }

  /** The world is known to compile: the bridge does it while the application is compiled. */
  private static void compileMeanwhile(BridgeProcess bridge, World world) {
    Thread thread =
        new Thread(
            () -> {
              try {
                bridge.client().check(world.description(), world.files());
              } catch (WorldException | SimulatorException e) {
                // The session that needs it meets the same trouble, and reports it.
              }
            },
            "sitaf-world");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public synchronized SimulatorEndpoint open() throws SimulatorException, InterruptedException {
    World offered = world;
    if (offered == null) {
      throw new IllegalStateException("the world was not checked");
    }
    for (int start = 1; ; start++) {
      BridgeProcess used = living();
      String name = "e" + ++endpoints;
      try {
        used.client().openEndpoint(name, offered.digest());
        return new Endpoint(used, name, used.share(name));
      } catch (IOException e) {
        boolean gone = used.end().isPresent();
        if (!gone || start == STARTS) {
          throw new SimulatorException("the simulator opens no endpoint: " + e.getMessage(), e);
        }
      }
    }
  }

  /** The bridge, or a fresh one where it died. */
  private BridgeProcess living() throws SimulatorException, InterruptedException {
    if (closed) {
      throw new SimulatorException("the build is over");
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
    bridges.startAhead();
    return current;
  }

  private static String keyOf(String description, Map<String, byte[]> files) {
    StringBuilder key = new StringBuilder(description);
    new TreeMap<>(files)
        .forEach(
            (path, content) -> key.append('\0').append(path).append('\0').append(sha256(content)));
    return sha256(key.toString().getBytes(StandardCharsets.UTF_8));
  }

  private static String sha256(byte[] content) {
    try {
      return java.util.HexFormat.of()
          .formatHex(java.security.MessageDigest.getInstance("SHA-256").digest(content));
    } catch (java.security.NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (bridge != null) {
      bridge.close();
      bridge = null;
    }
  }

  /** A socket of the bridge that one process of the test application is given. */
  private record Endpoint(BridgeProcess bridge, String name, Path socket)
      implements SimulatorEndpoint {
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
    public void close() {
      bridge.withdraw(name);
    }
  }
}
