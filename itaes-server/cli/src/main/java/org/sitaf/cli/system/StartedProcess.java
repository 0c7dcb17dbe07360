package org.sitaf.cli.system;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.cli.terminal.ProgressLine;

/**
 * A child process that prints a line when it is ready and ends when its standard input is closed.
 */
final class StartedProcess implements AutoCloseable {
  private static final Duration STOP_LIMIT = Duration.ofSeconds(10);
  private static final int LAST_LINES = 15;
  private static final long POLL_MS = 200;
  private static final Duration USUAL_START = Duration.ofSeconds(20);
  private static final Duration MIN_CPU_TIME = Duration.ofMillis(200);

  private final String name;
  private final Path log;
  private final Process process;
  private final CompletableFuture<Matcher> ready = new CompletableFuture<>();

  /**
   * Starts a process whose output is written to a log.
   *
   * @param environment additional variables; used for secrets, because arguments are visible to all
   *     users
   * @param ready pattern of the line that the process prints when it is ready
   */
  StartedProcess(
      String name, List<String> command, Map<String, String> environment, Path log, Pattern ready)
      throws IOException {
    this.name = name;
    this.log = log;
    File file = log.toFile();
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.appendTo(file));
    builder.environment().putAll(environment);
    this.process = builder.start();
    Thread reader = new Thread(() -> read(ready), "sitaf-" + name);
    reader.setDaemon(true);
    reader.start();
  }

  /**
   * Waits until the process is ready, as long as it makes progress.
   *
   * @param progress shown if the wait is longer than usual
   * @param others processes that this one waits for: their progress counts, too
   * @return the match of the ready line
   * @throws IOException if the process ends or the timeout expires; contains the end of its log
   */
  Matcher awaitReady(StartupTimeout timeout, ProgressLine progress, StartedProcess... others)
      throws IOException, InterruptedException {
    long began = System.nanoTime();
    long cameOn = began;
    Work seen = work(others);
    boolean reported = false;
    while (true) {
      try {
        return ready.get(POLL_MS, TimeUnit.MILLISECONDS);
      } catch (ExecutionException e) {
        process.waitFor(1, TimeUnit.SECONDS);
        throw new IOException("the " + name + " ended before it was ready" + lastLine(), e);
      } catch (TimeoutException e) {
        long now = System.nanoTime();
        Duration waited = Duration.ofNanos(now - began);
        Work done = work(others);
        if (done.isMoreThan(seen)) {
          cameOn = now;
          seen = done;
        }
        if (waited.compareTo(timeout.atMost()) > 0) {
          throw new IOException(
              "the " + name + " was not ready within " + waited.toSeconds() + " s" + lastLine(), e);
        }
        Duration still = Duration.ofNanos(now - cameOn);
        if (still.compareTo(timeout.withoutProgress()) > 0) {
          throw new IOException(
              "the %s is not ready after %d s and made no progress in the last %d s%s"
                  .formatted(name, waited.toSeconds(), still.toSeconds(), lastLine()),
              e);
        }
        if (waited.compareTo(USUAL_START) > 0) {
          if (!reported) {
            progress.step("Waiting for the %s, which starts slowly (log: %s)".formatted(name, log));
            reported = true;
          }
          progress.detail(waited.toSeconds() + " s");
        }
      }
    }
  }

  /**
   * Progress of processes.
   *
   * @param cpu total processor time
   * @param logged size of their logs in bytes
   */
  private record Work(Duration cpu, long logged) {
    /** Whether they used more processor time than an idle JVM, or wrote to a log. */
    boolean isMoreThan(Work before) {
      return logged > before.logged || cpu.minus(before.cpu).compareTo(MIN_CPU_TIME) > 0;
    }

    Work plus(Work other) {
      return new Work(cpu.plus(other.cpu), logged + other.logged);
    }
  }

  private Work work(StartedProcess... others) {
    Duration cpu = process.info().totalCpuDuration().orElse(Duration.ZERO);
    Work all = new Work(cpu, log.toFile().length());
    for (StartedProcess other : others) {
      all = all.plus(other.work());
    }
    return all;
  }

  /** Waits until the process ends. */
  int await() throws InterruptedException {
    return process.waitFor();
  }

  boolean isAlive() {
    return process.isAlive();
  }

  @Override
  public void close() {
    close(STOP_LIMIT);
  }

  /** Closes its standard input, and does not wait for its end. */
  void stop() {
    try {
      process.getOutputStream().close();
    } catch (IOException e) {
      process.destroyForcibly();
    }
  }

  /** Stops it, and kills it if it then runs longer than a limit. */
  void close(Duration limit) {
    stop();
    try {
      if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
    }
  }

  private void read(Pattern pattern) {
    try (BufferedReader lines =
            new BufferedReader(
                new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        Writer out =
            Files.newBufferedWriter(
                log,
                java.nio.file.StandardOpenOption.CREATE,
                java.nio.file.StandardOpenOption.APPEND)) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        Matcher matcher = pattern.matcher(line);
        if (matcher.find()) {
          ready.complete(matcher);
        }
        out.write(line + "\n");
        out.flush();
      }
    } catch (IOException e) {
      ready.completeExceptionally(e);
    }
    ready.completeExceptionally(new IOException("end of output"));
  }

  private String lastLine() {
    try {
      List<String> lines = Files.readAllLines(log);
      List<String> last = lines.subList(Math.max(0, lines.size() - LAST_LINES), lines.size());
      return "; the end of " + log + ":\n" + String.join("\n", last);
    } catch (IOException e) {
      return "; see " + log;
    }
  }
}
