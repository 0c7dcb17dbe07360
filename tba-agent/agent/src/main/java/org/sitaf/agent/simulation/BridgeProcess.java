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
 * A running {@code sitaf_bridge} in a sandbox, with a folder of its own for its sockets. It ends
 * when its standard input closes.
 */
final class BridgeProcess {
  /** For the bridge and the processes that compile its worlds. */
  static final ProcessLimits LIMITS = new ProcessLimits(2048, 1024, 16, Duration.ofHours(24));

  private static final Duration START = Duration.ofSeconds(60);
  private static final Duration DYING = Duration.ofMillis(500);
  private static final String LISTENING = "listening ";
  private static final String CONTROL = "control";

  /**
   * {@code sun_path} holds 108 bytes with its end; names of ours below the directory take a few.
   */
  private static final int MAX_DIRECTORY_PATH = 107 - "/b0123456789012345678/w/control".length();

  private final ConfinedProcess process;
  private final Path folder;
  private final BridgeOutput output;
  private final String target;
  private final SimulatorClient client;

  /** Why it was ended although it ran; empty where it was not. */
  private volatile String useless = "";

  private BridgeProcess(ConfinedProcess process, Path folder, BridgeOutput output, String target) {
    this.process = process;
    this.folder = folder;
    this.output = output;
    this.target = target;
    this.client = new SimulatorClient(target);
  }

  /**
   * Starts one and waits until it accepts calls.
   *
   * @param directory private to the caller; the bridge's folder is made there, or where temporary
   *     files are if the path of a socket would be too long
   */
  static BridgeProcess start(List<String> command, Path directory, Sandbox sandbox)
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
      process =
          sandbox.start(
              Confinement.of(full, working, temporary, LIMITS)
                  .reading(BridgeFiles.of(command, sandbox))
                  // Sockets of what compiles worlds lie there: a short path.
                  .withEnvironment(Map.of("TMPDIR", "/tmp", "OPENBLAS_NUM_THREADS", "1"))
                  .heldBackUntilLetGo());
    } catch (IOException e) {
      throw new SimulatorException(
          "the simulator cannot be started with '"
              + String.join(" ", command)
              + "': "
              + e.getMessage(),
          e);
    }
    BridgeOutput output = new BridgeOutput(process.errors());
    CompletableFuture<String> firstLine = new CompletableFuture<>();
    follow(process, firstLine);
    try {
      String line = firstLine.get(START.toSeconds(), TimeUnit.SECONDS);
      if (line.startsWith(LISTENING)) {
        return new BridgeProcess(process, folder, output, target);
      }
      throw failed(process, folder, output, "its first line is not 'listening ADDRESS': " + line);
    } catch (ExecutionException e) {
      throw failed(process, folder, output, String.valueOf(e.getCause().getMessage()));
    } catch (TimeoutException e) {
      throw failed(process, folder, output, "it did not listen within " + START.toSeconds() + " s");
    } catch (InterruptedException e) {
      end(process, folder);
      throw e;
    }
  }

  private static SimulatorException failed(
      ConfinedProcess process, Path folder, BridgeOutput output, String reason) {
    end(process, folder);
    return new SimulatorException(
        "the simulator could not be started: " + reason + output.lastLine());
  }

  private static Path newFolder(Path directory) throws IOException {
    Path absolute = Files.createDirectories(directory).toAbsolutePath();
    var onlyMe = PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"));
    return absolute.toString().getBytes(StandardCharsets.UTF_8).length <= MAX_DIRECTORY_PATH
        ? Files.createTempDirectory(absolute, "b", onlyMe)
        : Files.createTempDirectory("sitaf-bridge", onlyMe);
  }

  boolean isAlive() {
    return useless.isEmpty() && !hasExited();
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
   * Gives an endpoint's socket a second name, in a folder that the bridge cannot write: what is
   * mounted for a component is then the socket and nothing that took its place.
   */
  Path share(String name) throws IOException {
    Path shared = folder.resolve("e").resolve(name);
    Files.createLink(shared, folder.resolve("w").resolve(name));
    BasicFileAttributes attributes =
        Files.readAttributes(shared, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    if (!attributes.isOther()) {
      throw new IOException("the simulator's endpoint " + name + " is no socket");
    }
    return shared;
  }

  /** Closes an endpoint. A bridge that does not stop what it was asked to do is of no more use. */
  void withdraw(String name) {
    boolean interrupted = Thread.interrupted();
    if (isAlive() && !client.closesEndpoint(name)) {
      endAs("it went on with a call whose test application had ended");
    }
    try {
      Files.deleteIfExists(folder.resolve("e").resolve(name));
    } catch (IOException e) {
      // It goes with the folder.
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Why it does not answer; empty while it does. */
  Optional<SimulatorEnd> end() throws InterruptedException {
    if (process.awaitEnd(Duration.ZERO)) {
      return Optional.of(ended());
    }
    try {
      client.requireAnswer();
      return Optional.empty();
    } catch (SimulatorException e) {
      // The socket closes a moment before the process is gone.
      if (process.awaitEnd(DYING)) {
        return Optional.of(ended());
      }
      endAs(String.valueOf(e.getMessage()));
      return Optional.of(ended());
    }
  }

  private void endAs(String reason) {
    useless = reason;
    process.close();
  }

  private SimulatorEnd ended() {
    if (!useless.isEmpty()) {
      return new SimulatorEnd(useless, false);
    }
    Optional<String> limit = process.brokenLimit();
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
      // What is left behind is harmless: the next bridge has a folder of its own.
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Takes the first line, and reads on so that the bridge never waits for a full pipe. */
  private static void follow(ConfinedProcess process, CompletableFuture<String> firstLine) {
    Thread thread =
        new Thread(
            () -> {
              try (BufferedReader reader =
                  new BufferedReader(
                      new InputStreamReader(process.output(), StandardCharsets.UTF_8))) {
                String line = reader.readLine();
                if (line == null) {
                  process.awaitEnd(DYING);
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
