package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;

/** A running process of untrusted code, together with all processes that it started. */
public final class ConfinedProcess implements AutoCloseable {
  private static final Duration SIGNAL_TIMEOUT = Duration.ofSeconds(2);

  private final Process process;
  private final ProcessGroup group;
  private final ControlGroup controlGroup;
  private final int memoryMiB;
  private final int generations;
  private volatile @Nullable String exceededLimit;

  private ConfinedProcess(
      Process process,
      ProcessGroup group,
      ControlGroup controlGroup,
      int memoryMiB,
      int generations) {
    this.process = process;
    this.group = group;
    this.controlGroup = controlGroup;
    this.memoryMiB = memoryMiB;
    this.generations = generations;
  }

  /**
   * Starts a process with nothing of the agent's environment.
   *
   * @param variables in addition to those that every process gets
   * @param controlGroup group that the command enters; removed after the command has ended
   * @param generations number of processes between the started one and the requested command
   * @param onEnd called after the process and all that it started have ended
   */
  static ConfinedProcess start(
      List<String> command,
      Confinement confinement,
      Map<String, String> variables,
      ControlGroup controlGroup,
      int generations,
      Runnable onEnd)
      throws IOException {
    ProcessBuilder builder = new ProcessBuilder(withChannel(command, confinement));
    builder.directory(confinement.working().toFile());
    // The agent's environment may hold secrets.
    Map<String, String> environment = builder.environment();
    String path = environment.getOrDefault("PATH", "/usr/bin:/bin");
    environment.clear();
    environment.put("PATH", path);
    environment.put("HOME", confinement.working().toString());
    environment.put("TMPDIR", confinement.temporary().toString());
    environment.put("LANG", "C.UTF-8");
    environment.putAll(variables);
    ProcessGroup group = new ProcessGroup(ProcessGroup.markOf(confinement.working()));
    environment.put(ProcessGroup.VARIABLE, group.mark());
    DiskWatch disk = DiskWatch.of(confinement);
    Process process = ProcessStarter.start(builder);
    if (!confinement.keepsInputOpen()) {
      process.getOutputStream().close();
    }
    int memoryMiB = confinement.limits().memoryMiB();
    ConfinedProcess confined =
        new ConfinedProcess(process, group, controlGroup, memoryMiB, generations);
    MemoryWatch.start(
        process,
        controlGroup,
        memoryMiB,
        () -> confined.killFor(confined.memoryMessage()),
        () -> {
          controlGroup.remove();
          onEnd.run();
        });
    disk.start(process, confined::killFor);
    return confined;
  }

  /** Opens the channel outside the sandbox, where the named pipe is visible. */
  private static List<String> withChannel(List<String> command, Confinement confinement) {
    Path channel = confinement.channel();
    if (channel == null) {
      return command;
    }
    List<String> opening = new ArrayList<>();
    String redirection = Confinement.CHANNEL + ">\"$0\"";
    opening.addAll(List.of("/bin/sh", "-c", "exec \"$@\" " + redirection, channel.toString()));
    opening.addAll(command);
    return opening;
  }

  /** Sends a waiting process one line and closes its input. */
  public void release(String line) {
    try (OutputStream input = process.getOutputStream()) {
      input.write((line + "\n").getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      // The process has ended already; its exit code tells how.
    }
  }

  /**
   * Lets a process that was started ahead use only processor time that nobody else needs, or an
   * equal share again. Without effect unless {@link Sandbox#canIdle}.
   */
  public void setIdle(boolean idle) {
    controlGroup.setIdle(idle);
  }

  /** The input of a process that waits, for callers that send more than one line. */
  public OutputStream input() {
    return process.getOutputStream();
  }

  public InputStream output() {
    return process.getInputStream();
  }

  public InputStream errors() {
    return process.getErrorStream();
  }

  /** Its process id; that of the requested command if it runs without a sandbox. */
  public long pid() {
    return process.pid();
  }

  /** Waits for the end; returns whether the process ended within that time. */
  public boolean awaitEnd(Duration atMost) throws InterruptedException {
    return process.waitFor(atMost.toMillis(), TimeUnit.MILLISECONDS);
  }

  /**
   * Sends {@code SIGQUIT}, for which most runtimes print their stack traces. A process that does
   * not handle the signal ends.
   */
  public void requestStackTraces() throws InterruptedException {
    ProcessHandle target = process.toHandle();
    for (int i = 0; i < generations; i++) {
      Optional<ProcessHandle> child = target.children().findFirst();
      if (child.isEmpty()) {
        return;
      }
      target = child.get();
    }
    try {
      new ProcessBuilder("kill", "-QUIT", Long.toString(target.pid()))
          .redirectErrorStream(true)
          .start()
          .waitFor(SIGNAL_TIMEOUT.toMillis(), TimeUnit.MILLISECONDS);
    } catch (IOException e) {
      // Only the stack traces are missing; the caller kills the process next.
    }
  }

  /** The process outside the sandbox, the ancestor of all others. */
  ProcessHandle handle() {
    return process.toHandle();
  }

  /** Kills it and all processes that it started. */
  public void kill() throws InterruptedException {
    destroy();
    process.waitFor();
  }

  /** Kills background processes that it left, which would keep its output open. */
  public void killLeftovers() {
    controlGroup.kill();
    group.kill();
    controlGroup.remove();
  }

  /**
   * The exit code; 128 plus the signal number for a signal, as in a shell. Valid after the end
   * only.
   */
  public int exitCode() {
    return process.exitValue();
  }

  /** The limit that it was killed for. */
  public Optional<String> exceededLimit() {
    if (exceededLimit == null && controlGroup.exceededMemory()) {
      exceededLimit = memoryMessage();
    }
    return Optional.ofNullable(exceededLimit);
  }

  @Override
  public void close() {
    destroy();
  }

  private void killFor(String limit) {
    exceededLimit = limit;
    destroy();
  }

  private String memoryMessage() {
    return "it used more than " + memoryMiB + " MiB of memory";
  }

  private void destroy() {
    List<ProcessHandle> descendants = process.descendants().toList();
    process.destroyForcibly();
    descendants.forEach(ProcessHandle::destroyForcibly);
    controlGroup.kill();
    group.kill();
    controlGroup.remove();
  }
}
