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
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.Folders;

/** Starts the agent's own bridges, a new one for each build. */
final class BridgePool implements Simulator {
  private static final int MAX_KNOWN_WORLDS = 100;

  /**
   * Delay of a start ahead where it would take processor time from the build that just began; most
   * builds are over by then.
   */
  private static final long HEAD_START_MS = 1500;

  private final List<String> command;
  private final Path directory;
  private final Sandbox sandbox;

  /** Worlds that a bridge of this command has compiled, by their files. */
  private final Map<String, CompiledWorld> accepted =
      new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, CompiledWorld> eldest) {
          return size() > MAX_KNOWN_WORLDS;
        }
      };

  /** Starts the bridges and waits until they accept calls. */
  private final ScheduledExecutorService starter =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "sitaf-bridge-starter");
            thread.setDaemon(true);
            return thread;
          });

  private @Nullable Started idle;
  private int expected;
  private boolean closed;

  BridgePool(List<String> command, Path directory, Sandbox sandbox, int builds) {
    if (command.isEmpty()) {
      throw new IllegalArgumentException("the bridge's command is empty");
    }
    this.command = List.copyOf(command);
    this.directory = directory;
    this.sandbox = sandbox;
    this.expected = builds;
    deleteStaleFolders();
    synchronized (this) {
      startAhead();
    }
  }

  /** Deletes folders that the bridges of a killed agent left. */
  private void deleteStaleFolders() {
    if (Files.isDirectory(directory)) {
      try (var folders = Files.newDirectoryStream(directory, "b[0-9]*")) {
        for (Path folder : folders) {
          Folders.delete(folder);
        }
      } catch (IOException | DirectoryIteratorException e) {
        // They do no harm.
      }
    }
  }

  @Override
  public BuildSimulator forBuild() {
    return new OwnSimulator(this);
  }

  Sandbox sandbox() {
    return sandbox;
  }

  /** A guard of real devices; the caller closes it. */
  HardwareGuard startGuard(String devices) throws SimulatorException, InterruptedException {
    return HardwareGuard.start(command, directory, devices);
  }

  /** A bridge that no build has used; the caller closes it. */
  BridgeProcess take() throws SimulatorException, InterruptedException {
    while (true) {
      Started next = next();
      try {
        BridgeProcess bridge = started(next.bridge());
        // A bridge that died while it was idle is replaced.
        if (bridge.isAlive()) {
          return bridge;
        }
        bridge.close();
      } catch (SimulatorException e) {
        // So is one that died while it was started ahead: what ended it may be over.
        if (!next.ahead()) {
          throw e;
        }
      }
    }
  }

  /** Starts a bridge ahead, unless one is idle or no further build is expected. */
  synchronized void startAhead() {
    if (!closed && idle == null && expected > 0) {
      expected -= expected == UNLIMITED ? 0 : 1;
      idle = submit(true);
    }
  }

  /** Starts the next bridge without taking processor time from the build that took the last one. */
  synchronized void startNext() {
    if (sandbox.canIdle()) {
      startAhead();
    } else if (!closed) {
      starter.schedule(this::startAhead, HEAD_START_MS, TimeUnit.MILLISECONDS);
    }
  }

  synchronized Optional<CompiledWorld> acceptedWorld(String world) {
    return Optional.ofNullable(accepted.get(world));
  }

  synchronized void addAccepted(String world, CompiledWorld compiled) {
    accepted.put(world, compiled);
  }

  private synchronized Started next() throws SimulatorException {
    if (closed) {
      throw new SimulatorException("the simulator has been closed");
    }
    Started next = idle == null ? submit(false) : idle;
    idle = null;
    next.start().need();
    return next;
  }

  private Started submit(boolean ahead) {
    BridgeStart start = new BridgeStart();
    return new Started(
        start,
        starter.submit(() -> BridgeProcess.start(command, directory, sandbox, start)),
        ahead);
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

  /** Closes the bridge of a build that was cancelled during the start. */
  private static void closeWhenStarted(Future<BridgeProcess> future) {
    if (!future.cancel(true) && !future.isCancelled()) {
      try {
        future.get().close();
      } catch (ExecutionException | InterruptedException e) {
        // The start failed, or the thread was interrupted again; the bridge ends with the agent.
      }
    }
  }

  @Override
  public void close() {
    Started unused;
    synchronized (this) {
      closed = true;
      unused = idle;
      idle = null;
    }
    if (unused != null) {
      boolean interrupted = Thread.interrupted();
      closeWhenStarted(unused.bridge());
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
    starter.shutdownNow();
  }

  /** A bridge whose start has begun, before a build needed it if {@code ahead}. */
  private record Started(BridgeStart start, Future<BridgeProcess> bridge, boolean ahead) {}
}
