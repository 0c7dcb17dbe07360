package org.sitaf.agent.executor;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sitaf.agent.executor.ExecutionRequest.World;

/** A test application at work, in a JVM of its own. */
final class HarnessProcess implements AutoCloseable {
  private static final Duration OUTPUT_GRACE = Duration.ofSeconds(2);

  private final Process process;
  private final ProcessGroup group;
  private final LastWords lastWords = new LastWords();
  private final List<Thread> pumps;

  private HarnessProcess(Process process, ProcessGroup group, OutputSink sink) {
    this.process = process;
    this.group = group;
    this.pumps =
        List.of(
            pump(process.getInputStream(), sink::output),
            pump(
                process.getErrorStream(),
                text -> {
                  lastWords.add(text);
                  sink.output(text);
                }));
  }

  /**
   * Starts a process that begins at a case.
   *
   * @throws IOException when the process cannot be started, or its simulator is not there
   */
  static HarnessProcess start(ExecutionRequest request, Path results, int fromCase, OutputSink sink)
      throws IOException, InterruptedException {
    Path working = request.directory().resolve("run");
    Path temporary = request.directory().resolve("tmp");
    Files.createDirectories(working);
    Files.createDirectories(temporary);
    ProcessGroup group = new ProcessGroup(ProcessGroup.markOf(request.directory()));
    ProcessBuilder builder = new ProcessBuilder(command(request, results, fromCase, temporary));
    builder.directory(working.toFile());
    // Nothing of the agent's environment is the component's business; what it holds may be secret.
    Map<String, String> environment = builder.environment();
    String path = environment.getOrDefault("PATH", "/usr/bin:/bin");
    environment.clear();
    environment.put("PATH", path);
    environment.put("HOME", working.toString());
    environment.put("TMPDIR", temporary.toString());
    environment.put("LANG", "C.UTF-8");
    environment.put(ProcessGroup.VARIABLE, group.mark());
    Process process = builder.start();
    process.getOutputStream().close();
    return new HarnessProcess(process, group, sink);
  }

  private static List<String> command(
      ExecutionRequest request, Path results, int fromCase, Path temporary)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-Xmx" + request.limits().memoryMiB() + "m");
    // A suite is over before the optimising compiler pays; start-up is what counts.
    command.add("-XX:TieredStopAtLevel=1");
    command.add("-XX:+UseSerialGC");
    command.add("-Xshare:auto");
    command.add("-XX:-UsePerfData");
    command.add("-XX:-CreateCoredumpOnCrash");
    command.add("-XX:ErrorFile=" + request.directory().resolve("hs_err.log"));
    command.add("-Djava.io.tmpdir=" + temporary);
    command.add("-Dfile.encoding=UTF-8");
    command.add("-Dsun.stdout.encoding=UTF-8");
    command.add("-Dsun.stderr.encoding=UTF-8");
    command.add("-cp");
    command.add(
        request.classPath().stream()
            .map(Path::toString)
            .collect(Collectors.joining(File.pathSeparator)));
    command.add(request.mainClass());
    command.add("--suite");
    command.add(request.suiteFile().toString());
    command.add("--results");
    command.add(results.toString());
    World world = request.world();
    if (world != null) {
      command.add("--bridge");
      command.add(world.simulator().get());
      command.add("--world");
      command.add(world.description().toString());
    }
    command.add("--seed");
    command.add(Long.toString(request.suite().generation().seed()));
    command.add("--from");
    command.add(Integer.toString(fromCase));
    return command;
  }

  /** Waits for the end; true when it came within that time. */
  boolean awaitEnd(Duration atMost) throws InterruptedException {
    return process.waitFor(atMost.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** Ends it now, with all that it started. */
  void kill() throws InterruptedException {
    List<ProcessHandle> descendants = process.descendants().toList();
    process.destroyForcibly();
    descendants.forEach(ProcessHandle::destroyForcibly);
    group.kill();
    process.waitFor();
  }

  /** How it ended; only after its end. */
  ProcessEnd end() throws InterruptedException {
    // What it left behind would keep its output open.
    group.kill();
    for (Thread pump : pumps) {
      pump.join(OUTPUT_GRACE.toMillis());
    }
    return new ProcessEnd(process.exitValue(), lastWords.get());
  }

  @Override
  public void close() {
    process.destroyForcibly();
    group.kill();
  }

  private static Thread pump(InputStream stream, Consumer<String> sink) {
    Thread thread =
        new Thread(
            () -> {
              // Bytes that are no UTF-8 become replacement characters here; the log is always text.
              try (Reader reader = new InputStreamReader(stream, StandardCharsets.UTF_8)) {
                char[] buffer = new char[8192];
                for (int n = reader.read(buffer); n >= 0; n = reader.read(buffer)) {
                  sink.accept(new String(buffer, 0, n));
                }
              } catch (IOException e) {
                // The process is gone, and its output with it.
              }
            },
            "sitaf-output");
    thread.setDaemon(true);
    thread.start();
    return thread;
  }
}
