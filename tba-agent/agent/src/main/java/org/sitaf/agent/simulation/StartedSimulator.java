package org.sitaf.agent.simulation;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.Folders;

/** Bridges of the agent's own, a fresh one for each build. */
final class StartedSimulator implements Simulator {
  private static final int REMEMBERED_WORLDS = 100;

  private final List<String> command;
  private final Path directory;
  private final Sandbox sandbox;

  /** Digests of worlds that a bridge of this command has compiled, by their files. */
  private final Map<String, String> accepted =
      new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, String> eldest) {
          return size() > REMEMBERED_WORLDS;
        }
      };

  /**
   * Starts all bridges: a confined process ends with the thread that started it, and builds'
   * threads end before a bridge that was started ahead.
   */
  private final ExecutorService starter =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "sitaf-bridge-starter");
            thread.setDaemon(true);
            return thread;
          });

  private @Nullable Future<BridgeProcess> spare;
  private int expected;
  private boolean closed;

  StartedSimulator(List<String> command, Path directory, Sandbox sandbox, int builds) {
    if (command.isEmpty()) {
      throw new IllegalArgumentException("the bridge's command is empty");
    }
    this.command = List.copyOf(command);
    this.directory = directory;
    this.sandbox = sandbox;
    this.expected = builds;
    deleteLeftOvers();
    synchronized (this) {
      startAhead();
    }
  }

  /** Folders of bridges that ended with an agent that was killed. */
  private void deleteLeftOvers() {
    if (Files.isDirectory(directory)) {
      try (var folders = Files.newDirectoryStream(directory, "b[0-9]*")) {
        for (Path folder : folders) {
          Folders.delete(folder);
        }
      } catch (IOException | DirectoryIteratorException e) {
        // They are in nobody's way.
      }
    }
  }

  @Override
  public BuildSimulator forBuild() {
    return new OwnSimulator(this);
  }

  @Override
  public void awaitReady() throws InterruptedException {
    Future<BridgeProcess> next;
    synchronized (this) {
      next = spare;
    }
    if (next != null) {
      try {
        next.get();
      } catch (ExecutionException e) {
        // The build that needs it reports it.
      }
    }
  }

  Sandbox sandbox() {
    return sandbox;
  }

  /** A bridge that nobody has used; it is the caller's, who closes it. */
  BridgeProcess take() throws SimulatorException, InterruptedException {
    while (true) {
      Future<BridgeProcess> next = nextSpare();
      BridgeProcess bridge = started(next);
      // One that died while it waited is no reason to refuse a build.
      if (bridge.isAlive()) {
        return bridge;
      }
      bridge.close();
    }
  }

  /** Starts one ahead, unless one waits already or no further build is expected. */
  synchronized void startAhead() {
    if (!closed && spare == null && expected > 0) {
      expected -= expected == ALWAYS ? 0 : 1;
      spare = starter.submit(this::start);
    }
  }

  synchronized Optional<String> digestOf(String world) {
    return Optional.ofNullable(accepted.get(world));
  }

  synchronized void accepted(String world, String digest) {
    accepted.put(world, digest);
  }

  private synchronized Future<BridgeProcess> nextSpare() throws SimulatorException {
    if (closed) {
      throw new SimulatorException("the simulator was ended");
    }
    Future<BridgeProcess> next = spare == null ? starter.submit(this::start) : spare;
    spare = null;
    return next;
  }

  private BridgeProcess start() throws SimulatorException, InterruptedException {
    return BridgeProcess.start(command, directory, sandbox);
  }

  private static BridgeProcess started(Future<BridgeProcess> future)
      throws SimulatorException, InterruptedException {
    try {
      return future.get();
    } catch (InterruptedException e) {
      closeWhenStarted(future);
      throw e;
    } catch (ExecutionException e) {
      if (e.getCause() instanceof SimulatorException failure) {
        throw failure;
      }
      throw new SimulatorException("the simulator could not be started: " + e.getCause(), e);
    }
  }

  /** A bridge whose build was cancelled while it started belongs to nobody. */
  private static void closeWhenStarted(Future<BridgeProcess> future) {
    if (!future.cancel(true) && !future.isCancelled()) {
      try {
        future.get().close();
      } catch (ExecutionException | InterruptedException e) {
        // It never started, or the thread is interrupted again; it ends with the agent.
      }
    }
  }

  @Override
  public void close() {
    Future<BridgeProcess> left;
    synchronized (this) {
      closed = true;
      left = spare;
      spare = null;
    }
    if (left != null) {
      boolean interrupted = Thread.interrupted();
      closeWhenStarted(left);
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
    starter.shutdownNow();
  }
}
