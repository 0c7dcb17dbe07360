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

/** A process of other people's code at work, with all that it started. */
public final class ConfinedProcess implements AutoCloseable {
  private static final Duration SIGNAL = Duration.ofSeconds(2);

  private final Process process;
  private final ProcessGroup group;
  private final ControlGroup controlGroup;
  private final int memoryMiB;
  private final int generations;
  private volatile @Nullable String broken;

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
   * @param variables in addition to those that every process has
   * @param controlGroup which the command enters; removed after its end
   * @param generations how many processes lie between the one that is started and the one that was
   *     asked for
   * @param onEnd what is done after its end and that of all that it started
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
    // Nothing of the agent's environment is the component's business; what it holds may be secret.
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
    Process process = builder.start();
    if (!confinement.heldBack()) {
      process.getOutputStream().close();
    }
    int memoryMiB = confinement.limits().memoryMiB();
    ConfinedProcess confined =
        new ConfinedProcess(process, group, controlGroup, memoryMiB, generations);
    MemoryWatch.over(
        process,
        controlGroup,
        memoryMiB,
        () -> confined.breakOff(confined.memoryBroken()),
        () -> {
          controlGroup.remove();
          onEnd.run();
        });
    disk.over(process, confined::breakOff);
    return confined;
  }

  /** Opens the channel outside of all confinement, where the pipe is a file that can be opened. */
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

  /** Tells a process that was held back to go on: this line, and the end of its input. */
  public void letGo(String line) {
    try (OutputStream input = process.getOutputStream()) {
      input.write((line + "\n").getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      // It has ended already; how, its end tells.
    }
  }

  /** The input of a process that was held back, for what is more than a line. */
  public OutputStream input() {
    return process.getOutputStream();
  }

  public InputStream output() {
    return process.getInputStream();
  }

  public InputStream errors() {
    return process.getErrorStream();
  }

  /** Waits for the end; true when it came within that time. */
  public boolean awaitEnd(Duration atMost) throws InterruptedException {
    return process.waitFor(atMost.toMillis(), TimeUnit.MILLISECONDS);
  }

  /**
   * Asks the process for its stacks, as runtimes give them at {@code SIGQUIT}; one that does not
   * know the signal ends.
   */
  public void askForStacks() throws InterruptedException {
    ProcessHandle asked = process.toHandle();
    for (int i = 0; i < generations; i++) {
      Optional<ProcessHandle> child = asked.children().findFirst();
      if (child.isEmpty()) {
        return;
      }
      asked = child.get();
    }
    try {
      new ProcessBuilder("kill", "-QUIT", Long.toString(asked.pid()))
          .redirectErrorStream(true)
          .start()
          .waitFor(SIGNAL.toMillis(), TimeUnit.MILLISECONDS);
    } catch (IOException e) {
      // Without the signal there are no stacks; the process is killed all the same.
    }
  }

  /** The process outside, of which all others of it descend. */
  ProcessHandle handle() {
    return process.toHandle();
  }

  /** Ends it now, with all that it started. */
  public void kill() throws InterruptedException {
    destroy();
    process.waitFor();
  }

  /** Ends what it left behind, which would keep its output open. */
  public void killRest() {
    controlGroup.kill();
    group.kill();
    controlGroup.remove();
  }

  /** Its exit code; above 128 a signal's number is added, as shells have it. Only after its end. */
  public int exitCode() {
    return process.exitValue();
  }

  /** Which limit it was ended for. */
  public Optional<String> brokenLimit() {
    if (broken == null && controlGroup.exceededMemory()) {
      broken = memoryBroken();
    }
    return Optional.ofNullable(broken);
  }

  @Override
  public void close() {
    destroy();
  }

  private void breakOff(String limit) {
    broken = limit;
    destroy();
  }

  private String memoryBroken() {
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
