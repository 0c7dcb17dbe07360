package org.sitaf.agent.simulation;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.sitaf.agent.sandbox.ConfinedProcess;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.Folders;

/**
 * A running {@code sitaf_bridge} in a sandbox, with its own folder for sockets. It ends when its
 * standard input is closed.
 */
final class BridgeProcess {
  /** Shared by the bridge and the processes that compile its worlds. */
  static final ProcessLimits LIMITS = new ProcessLimits(2048, 1024, 16, Duration.ofHours(24));

  private static final Duration START_TIMEOUT = Duration.ofSeconds(60);
  private static final Duration EXIT_GRACE = Duration.ofMillis(500);
  private static final String LISTENING = "listening ";
  private static final String CONTROL = "control";
  private static final String GUARD = "guard";

  /** What is appended to the name of an endpoint's gRPC socket for its socket of operations. */
  private static final String OPERATIONS = ".ops";

  /**
   * {@code sun_path} holds 108 bytes including the terminator; some are needed for names in the
   * directory.
   */
  private static final int MAX_DIRECTORY_PATH = 107 - "/b0123456789012345678/w/control".length();

  private final ConfinedProcess process;
  private final Path folder;
  private final BridgeOutput output;
  private final String target;
  private final SimulatorClient client;

  /** Why the agent killed it; empty if it did not. */
  private volatile String terminationReason = "";

  private BridgeProcess(ConfinedProcess process, Path folder, BridgeOutput output, String target) {
    this.process = process;
    this.folder = folder;
    this.output = output;
    this.target = target;
    this.client = new SimulatorClient(target);
  }

  /**
   * Starts a bridge and waits until it accepts calls.
   *
   * @param directory private to the caller; the bridge's folder is created there, or in the default
   *     folder for temporary files if the path of a socket would be too long
   * @param start the time limit begins when a build needs the bridge
   */
  static BridgeProcess start(
      List<String> command, Path directory, Sandbox sandbox, BridgeStart start)
      throws SimulatorException, InterruptedException {
    Path folder;
    ConfinedProcess process;
    String target;
    try {
      folder = newFolder(directory);
      Path working = Files.createDirectory(folder.resolve("w"));
      Path temporary = Files.createDirectory(folder.resolve("t"));
      Files.createDirectory(folder.resolve("e"));
      target = "unix:" + working.resolve(CONTROL);
      List<String> full = new ArrayList<>(command);
      full.addAll(List.of("serve", "--listen", target, "--endpoints", working.toString()));
      full.add("--stop-with-stdin");
      // A debugger may halt the test application for long; the sessions end with this bridge.
      full.addAll(List.of("--default-lease", "86400"));
      process =
          sandbox.start(
              Confinement.of(full, working, temporary, LIMITS)
                  .reading(BridgeFiles.of(command, sandbox))
                  // Processes that compile worlds create sockets there, so the path must be short.
                  .withEnvironment(Map.of("TMPDIR", "/tmp", "OPENBLAS_NUM_THREADS", "1"))
                  .withInputOpen());
    } catch (IOException e) {
      throw new SimulatorException(
          "the simulator cannot be started with '"
              + String.join(" ", command)
              + "': "
              + e.getMessage(),
          e);
    }
    start.setProcess(process);
    BridgeOutput output = new BridgeOutput(process.errors());
    CompletableFuture<String> firstLine = new CompletableFuture<>();
    readOutput(process, firstLine);
    try {
      String line = firstLine(firstLine, start);
      if (line.startsWith(LISTENING)) {
        return new BridgeProcess(process, folder, output, target);
      }
      throw failed(process, folder, output, "expected the line 'listening ADDRESS', got: " + line);
    } catch (ExecutionException e) {
      throw failed(process, folder, output, String.valueOf(e.getCause().getMessage()));
    } catch (TimeoutException e) {
      throw failed(process, folder, output, "no answer within " + START_TIMEOUT.toSeconds() + " s");
    } catch (InterruptedException e) {
      end(process, folder);
      throw e;
    }
  }

  private static String firstLine(CompletableFuture<String> line, BridgeStart start)
      throws InterruptedException, ExecutionException, TimeoutException {
    while (true) {
      try {
        return line.get(START_TIMEOUT.toMillis(), TimeUnit.MILLISECONDS);
      } catch (TimeoutException e) {
        // A bridge that is started ahead may have to wait for a processor.
        if (start.neededFor().compareTo(START_TIMEOUT) >= 0) {
          throw e;
        }
      }
    }
  }

  private static SimulatorException failed(
      ConfinedProcess process, Path folder, BridgeOutput output, String reason) {
    // Before its streams are closed, which would discard what it wrote last.
    String lastLine = output.lastLine();
    end(process, folder);
    return new SimulatorException("the simulator could not be started: " + reason + lastLine);
  }

  /** A folder whose path is short enough for sockets. */
  static Path newFolder(Path directory) throws IOException {
    Path absolute = Files.createDirectories(directory).toAbsolutePath();
    var ownerOnly =
        PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"));
    return absolute.toString().getBytes(StandardCharsets.UTF_8).length <= MAX_DIRECTORY_PATH
        ? Files.createTempDirectory(absolute, "b", ownerOnly)
        : Files.createTempDirectory("sitaf-bridge", ownerOnly);
  }

  boolean isAlive() {
    return terminationReason.isEmpty() && !hasExited();
  }

  private boolean hasExited() {
    boolean interrupted = Thread.interrupted();
    try {
      return process.awaitEnd(Duration.ZERO);
    } catch (InterruptedException e) {
      interrupted = true;
      return false;
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  String target() {
    return target;
  }

  SimulatorClient client() {
    return client;
  }

  /**
   * Links an endpoint's sockets into a folder that the bridge cannot write, so that the bridge
   * cannot replace the files that are mounted for a component.
   *
   * @return the one for gRPC; the one for operations is beside it, if there is one
   */
  Path share(String name) throws IOException {
    if (Files.exists(folder.resolve("w").resolve(name + OPERATIONS), LinkOption.NOFOLLOW_LINKS)) {
      link(name + OPERATIONS);
    }
    return link(name);
  }

  private Path link(String name) throws IOException {
    Path shared = folder.resolve("e").resolve(name);
    Files.createLink(shared, folder.resolve("w").resolve(name));
    BasicFileAttributes attributes =
        Files.readAttributes(shared, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    if (!attributes.isOther()) {
      throw new IOException("the simulator's endpoint " + name + " is not a socket");
    }
    return shared;
  }

  /**
   * Gives the bridge access to the guard of real devices.
   *
   * @return the gRPC target
   */
  String admit(Path guard) throws IOException {
    Path linked = folder.resolve("w").resolve(GUARD);
    Files.deleteIfExists(linked);
    Files.createLink(linked, guard);
    return "unix:" + linked;
  }

  /** Closes an endpoint. A bridge that does not stop the endpoint's calls is killed. */
  void closeEndpoint(String name) {
    boolean interrupted = Thread.interrupted();
    if (isAlive() && !client.closesEndpoint(name)) {
      terminate("it continued a call after the test application had ended");
    }
    try {
      Files.deleteIfExists(folder.resolve("e").resolve(name));
      Files.deleteIfExists(folder.resolve("e").resolve(name + OPERATIONS));
    } catch (IOException e) {
      // The file is deleted with its folder.
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Why it does not answer; empty if it does. */
  Optional<SimulatorEnd> end() throws InterruptedException {
    if (process.awaitEnd(Duration.ZERO)) {
      return Optional.of(ended());
    }
    try {
      client.requireAnswer();
      return Optional.empty();
    } catch (SimulatorException e) {
      // The socket closes shortly before the process ends.
      if (process.awaitEnd(EXIT_GRACE)) {
        return Optional.of(ended());
      }
      terminate(String.valueOf(e.getMessage()));
      return Optional.of(ended());
    }
  }

  private void terminate(String reason) {
    terminationReason = reason;
    process.close();
  }

  private SimulatorEnd ended() {
    if (!terminationReason.isEmpty()) {
      return new SimulatorEnd(terminationReason, false);
    }
    Optional<String> limit = process.exceededLimit();
    return limit.isPresent()
        ? new SimulatorEnd(limit.get(), true)
        : new SimulatorEnd(
            "it ended with exit code " + process.exitCode() + output.lastLine(), false);
  }

  void close() {
    client.close();
    end(process, folder);
  }

  private static void end(ConfinedProcess process, Path folder) {
    boolean interrupted = Thread.interrupted();
    try {
      process.kill();
    } catch (InterruptedException e) {
      interrupted = true;
    }
    try {
      Folders.delete(folder);
    } catch (IOException e) {
      // Harmless: the next bridge uses another folder.
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Reads the first line, and discards the rest so that the bridge never blocks on a full pipe. */
  private static void readOutput(ConfinedProcess process, CompletableFuture<String> firstLine) {
    Thread thread =
        new Thread(
            () -> {
              try (BufferedReader reader =
                  new BufferedReader(
                      new InputStreamReader(process.output(), StandardCharsets.UTF_8))) {
                String line = reader.readLine();
                if (line == null) {
                  process.awaitEnd(EXIT_GRACE);
                  firstLine.completeExceptionally(
                      new IOException("it ended with exit code " + process.exitCode()));
                  return;
                }
                firstLine.complete(line);
                char[] rest = new char[4096];
                while (reader.read(rest) >= 0) {
                  // Only the first line counts.
                }
              } catch (IOException | InterruptedException | IllegalThreadStateException e) {
                firstLine.completeExceptionally(e);
              }
            },
            "sitaf-bridge-output");
    thread.setDaemon(true);
    thread.start();
  }
}
