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
import org.sitaf.cli.ProgressLine;

/**
 * A process of ours: says in a line of its output that it is ready, and ends when its standard
 * input closes.
 */
final class StartedProcess implements AutoCloseable {
  private static final Duration STOP_LIMIT = Duration.ofSeconds(10);
  private static final int LAST_LINES = 15;
  private static final long LOOK_MS = 200;
  private static final Duration EXPECTED = Duration.ofSeconds(20);
  private static final Duration SIGN_OF_WORK = Duration.ofMillis(200);

  private final String name;
  private final Path log;
  private final Process process;
  private final CompletableFuture<Matcher> ready = new CompletableFuture<>();

  /**
   * Starts a process whose output goes to a log.
   *
   * @param environment added to this process's own; secrets go this way, for arguments are seen by
   *     everybody on the machine
   * @param ready found in the line that says that it is ready
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
   * Waits until it is ready, for as long as it comes on.
   *
   * @param progress is told of a wait that is longer than people expect
   * @param others what this process waits for itself: while they come on, so does it
   * @return what was found in the line that says so
   * @throws IOException if it ends before, or patience does; the message holds the end of its log
   */
  Matcher awaitReady(Patience patience, ProgressLine progress, StartedProcess... others)
      throws IOException, InterruptedException {
    long began = System.nanoTime();
    long cameOn = began;
    Work seen = work(others);
    boolean told = false;
    while (true) {
      try {
        return ready.get(LOOK_MS, TimeUnit.MILLISECONDS);
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
        if (waited.compareTo(patience.atMost()) > 0) {
          throw new IOException(
              "the " + name + " was not ready within " + waited.toSeconds() + " s" + lastLine(),
              e);
        }
        Duration still = Duration.ofNanos(now - cameOn);
        if (still.compareTo(patience.withoutProgress()) > 0) {
          throw new IOException(
              "the %s is not ready after %d s, and did nothing for the last %d s%s"
                  .formatted(name, waited.toSeconds(), still.toSeconds(), lastLine()),
              e);
        }
        if (waited.compareTo(EXPECTED) > 0) {
          if (!told) {
            progress.step(
                "Waiting for the %s, which starts slowly: this machine is busy (log: %s)"
                    .formatted(name, log));
            told = true;
          }
          progress.detail(waited.toSeconds() + " s");
        }
      }
    }
  }

  /**
   * What processes have done so far.
   *
   * @param cpu the time that they have had of a processor
   * @param logged bytes that they have written
   */
  private record Work(Duration cpu, long logged) {
    /** More than a virtual machine does that only waits. */
    boolean isMoreThan(Work before) {
      return logged > before.logged || cpu.minus(before.cpu).compareTo(SIGN_OF_WORK) > 0;
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

  /** Waits for the end of the process. */
  int await() throws InterruptedException {
    return process.waitFor();
  }

  boolean isAlive() {
    return process.isAlive();
  }

  @Override
  public void close() {
    try {
      process.getOutputStream().close();
      if (!process.waitFor(STOP_LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
        process.destroyForcibly();
      }
    } catch (IOException e) {
      process.destroyForcibly();
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
      return "; the end of " + log + ":\n  " + String.join("\n  ", last);
    } catch (IOException e) {
      return "; see " + log;
    }
  }
}
