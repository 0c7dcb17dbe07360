package org.sitaf.agent.simulation;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.sitaf.agent.spool.Folders;

/**
 * The process between the simulator of a build and the providers of its real devices. It runs
 * outside of the sandbox, because only it may reach a provider: neither the simulator, which
 * compiles worlds of others, nor the component can. It stops the devices when its standard input is
 * closed, also by the death of this agent.
 */
final class HardwareGuard implements AutoCloseable {
  private static final String LISTENING = "listening ";
  private static final long END_S = 5;

  private final Process process;
  private final Path folder;
  private final Path socket;

  private HardwareGuard(Process process, Path folder, Path socket) {
    this.process = process;
    this.folder = folder;
    this.socket = socket;
  }

  /**
   * Starts a guard, which holds the devices until it is closed.
   *
   * @param command starts {@code sitaf_bridge}
   * @param devices its configuration
   * @throws SimulatorException if a provider does not answer or is held by another build
   */
  static HardwareGuard start(List<String> command, Path directory, String devices)
      throws SimulatorException, InterruptedException {
    try {
      Path folder = BridgeProcess.newFolder(directory);
      Path socket = folder.resolve("guard");
      Path file = Files.writeString(folder.resolve("devices.json"), devices);
      List<String> full = new ArrayList<>(command);
      full.addAll(List.of("guard", "--listen", "unix:" + socket, "--devices", file.toString()));
      ProcessBuilder builder = new ProcessBuilder(full).directory(folder.toFile());
      Map<String, String> environment = builder.environment();
      environment.keySet().retainAll(List.of("PATH", "LANG", "LC_ALL", "HOME"));
      Process process = builder.start();
      BridgeOutput errors = new BridgeOutput(process.getErrorStream());
      BufferedReader output =
          new BufferedReader(
              new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
      String line = output.readLine();
      if (line != null && line.startsWith(LISTENING)) {
        return new HardwareGuard(process, folder, socket);
      }
      process.destroyForcibly();
      Folders.delete(folder);
      throw new SimulatorException("the devices cannot be used: " + errors.text());
    } catch (IOException e) {
      throw new SimulatorException("the hardware guard cannot be started: " + e.getMessage(), e);
    }
  }

  /** The socket, which each bridge of the build gets. */
  Path socket() {
    return socket;
  }

  /** Whether it still guards the devices. */
  boolean isAlive() {
    return process.isAlive();
  }

  @Override
  public void close() {
    boolean interrupted = Thread.interrupted();
    try {
      process.getOutputStream().close();
      if (!process.waitFor(END_S, TimeUnit.SECONDS)) {
        // The providers stop their devices when the connection is lost.
        process.destroyForcibly();
      }
      Folders.delete(folder);
    } catch (IOException e) {
      process.destroyForcibly();
    } catch (InterruptedException e) {
      interrupted = true;
      process.destroyForcibly();
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
