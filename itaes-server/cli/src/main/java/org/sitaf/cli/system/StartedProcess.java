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

/**
 * A process of ours: says in a line of its output that it is ready, and ends when its standard
 * input closes.
 */
final class StartedProcess implements AutoCloseable {
  private static final Duration STOP_LIMIT = Duration.ofSeconds(10);
  private static final int LAST_LINES = 15;

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
   * Waits until it is ready.
   *
   * @return what was found in the line that says so
   * @throws IOException when it ends before, or takes too long; the message holds the end of its
   *     log
   */
  Matcher awaitReady(Duration limit) throws IOException, InterruptedException {
    try {
      return ready.get(limit.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      throw new IOException(
          "the " + name + " was not ready within " + limit.toSeconds() + " s" + lastWords(), e);
    } catch (ExecutionException e) {
      process.waitFor(1, TimeUnit.SECONDS);
      throw new IOException("the " + name + " ended before it was ready" + lastWords(), e);
    }
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

  private String lastWords() {
    try {
      List<String> lines = Files.readAllLines(log);
      List<String> last = lines.subList(Math.max(0, lines.size() - LAST_LINES), lines.size());
      return "; the end of " + log + ":\n  " + String.join("\n  ", last);
    } catch (IOException e) {
      return "; see " + log;
    }
  }
}
