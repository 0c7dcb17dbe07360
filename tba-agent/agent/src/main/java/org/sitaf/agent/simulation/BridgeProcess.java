package org.sitaf.agent.simulation;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;

/**
 * A running {@code sitaf_bridge}, on a Unix socket that only this user reaches. It ends when its
 * standard input closes.
 */
final class BridgeProcess {
  private static final Duration START = Duration.ofSeconds(60);
  private static final Duration STOP = Duration.ofSeconds(3);
  private static final String LISTENING = "listening ";

  /** {@code sun_path} holds 108 bytes with its end; names of ours take a few. */
  private static final int MAX_SOCKET_PATH = 100;

  private static final String LOG = "bridge.log";

  private final Process process;
  private final Path socketDirectory;
  private final String target;

  private BridgeProcess(Process process, Path socketDirectory, String target) {
    this.process = process;
    this.socketDirectory = socketDirectory;
    this.target = target;
  }

  static BridgeProcess start(List<String> command, Path directory)
      throws SimulatorException, InterruptedException {
    Path sockets;
    Process process;
    Path log = directory.resolve(LOG);
    try {
      Files.createDirectories(directory);
      sockets = socketDirectory(directory);
      List<String> full = new ArrayList<>(command);
      full.addAll(
          List.of("serve", "--listen", "unix:" + sockets.resolve("bridge"), "--stop-with-stdin"));
      process =
          new ProcessBuilder(full).redirectError(ProcessBuilder.Redirect.to(log.toFile())).start();
    } catch (IOException e) {
      throw new SimulatorException(
          "the simulator cannot be started with '"
              + String.join(" ", command)
              + "': "
              + e.getMessage(),
          e);
    }
    CompletableFuture<String> firstLine = new CompletableFuture<>();
    follow(process, firstLine);
    try {
      String line = firstLine.get(START.toSeconds(), TimeUnit.SECONDS);
      if (line.startsWith(LISTENING)) {
        return new BridgeProcess(process, sockets, line.substring(LISTENING.length()).strip());
      }
      throw failed(process, sockets, log, "its first line is not 'listening ADDRESS': " + line);
    } catch (ExecutionException e) {
      throw failed(process, sockets, log, String.valueOf(e.getCause().getMessage()));
    } catch (TimeoutException e) {
      throw failed(process, sockets, log, "it did not listen within " + START.toSeconds() + " s");
    } catch (InterruptedException e) {
      end(process, sockets);
      throw e;
    }
  }

  private static SimulatorException failed(Process process, Path sockets, Path log, String reason) {
    end(process, sockets);
    return new SimulatorException("the simulator could not be started: " + reason + lastLine(log));
  }

  private static String lastLine(Path log) {
    try (Stream<String> lines = Files.lines(log, StandardCharsets.ISO_8859_1)) {
      return lines
          .filter(line -> !line.isBlank())
          .reduce((earlier, later) -> later)
          .map(line -> " (" + line.strip() + ")")
          .orElse("");
    } catch (IOException | java.io.UncheckedIOException e) {
      return "";
    }
  }

  boolean isAlive() {
    // The process object learns of an end a moment later than the system does.
    return process.isAlive() && process.toHandle().isAlive();
  }

  String target() {
    return target;
  }

  void close() {
    end(process, socketDirectory);
  }

  private static void end(Process process, Path sockets) {
    try {
      process.getOutputStream().close();
    } catch (IOException e) {
      // It is gone already.
    }
    process.destroy();
    boolean interrupted = false;
    try {
      if (!process.waitFor(STOP.toMillis(), TimeUnit.MILLISECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      interrupted = true;
      process.destroyForcibly();
    }
    try {
      Files.deleteIfExists(sockets.resolve("bridge"));
      Files.deleteIfExists(sockets);
    } catch (IOException e) {
      // A socket left behind is harmless: the next bridge has a folder of its own.
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private static Path socketDirectory(Path directory) throws IOException {
    var onlyMe = PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"));
    Path absolute = directory.toAbsolutePath();
    boolean fits =
        absolute
                .resolve("s0123456789012345678/bridge")
                .toString()
                .getBytes(StandardCharsets.UTF_8)
                .length
            <= MAX_SOCKET_PATH;
    return fits
        ? Files.createTempDirectory(absolute, "s", onlyMe)
        : Files.createTempDirectory("sitaf", onlyMe);
  }

  /** Takes the first line, and reads on so that the bridge never waits for a full pipe. */
  private static void follow(Process process, CompletableFuture<String> firstLine) {
    Thread thread =
        new Thread(
            () -> {
              try (BufferedReader reader =
                  new BufferedReader(
                      new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
                String line = reader.readLine();
                if (line == null) {
                  firstLine.completeExceptionally(
                      new IOException("it ended with exit code " + process.waitFor()));
                  return;
                }
                firstLine.complete(line);
                while (line != null) {
                  line = reader.readLine();
                }
              } catch (IOException | InterruptedException e) {
                firstLine.completeExceptionally(e);
              }
            },
            "sitaf-bridge-output");
    thread.setDaemon(true);
    thread.start();
  }
}
