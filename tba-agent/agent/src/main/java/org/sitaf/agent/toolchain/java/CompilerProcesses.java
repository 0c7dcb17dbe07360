package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.CompilationException;

/**
 * Starts a compiler for each compilation, the next one ahead. A process never handles two requests,
 * so that the sources of one user cannot influence the classes of another.
 */
final class CompilerProcesses {
  private final CompilerSetup setup;
  private final Path directory;
  private final AtomicLong count = new AtomicLong();
  private @Nullable CompilerProcess ahead;
  private boolean stopped;

  /**
   * Creates the pool without a process.
   *
   * @param directory folder for their files; several agents may share it
   */
  CompilerProcesses(CompilerSetup setup, Path directory) {
    this.setup = setup;
    this.directory = directory;
  }

  /** Starts the compiler of the next compilation, unless it is running. */
  synchronized void startAhead(Sandbox sandbox) throws IOException, InterruptedException {
    if (!stopped && (ahead == null || !ahead.isReadyIn(sandbox))) {
      endAhead();
      CompilerProcess started = start(sandbox);
      started.setIdle(true);
      ahead = started;
    }
  }

  /** Ends the process that was started ahead and starts no more. */
  synchronized void stop() {
    stopped = true;
    endAhead();
  }

  private void endAhead() {
    if (ahead != null) {
      ahead.close();
      ahead = null;
    }
  }

  private synchronized CompilerProcess take(Sandbox sandbox)
      throws IOException, InterruptedException {
    CompilerProcess taken = ahead;
    if (taken == null || !taken.isReadyIn(sandbox)) {
      endAhead();
      taken = start(sandbox);
    }
    ahead = null;
    taken.setIdle(false);
    return taken;
  }

  private CompilerProcess start(Sandbox sandbox) throws IOException {
    String own = ProcessHandle.current().pid() + "-";
    if (count.get() == 0) {
      deleteStale(own);
    }
    return CompilerProcess.start(
        setup, sandbox, directory.resolve(own + System.nanoTime() + "-" + count.incrementAndGet()));
  }

  /** Deletes folders whose names start with the id of a process that has ended. */
  private void deleteStale(String own) throws IOException {
    Files.createDirectories(directory);
    List<Path> folders;
    try (Stream<Path> all = Files.list(directory)) {
      folders = all.toList();
    }
    for (Path folder : folders) {
      String name = folder.getFileName().toString();
      if (name.matches("[0-9]{1,18}-.*")
          && !name.startsWith(own)
          && ProcessHandle.of(Long.parseLong(name.substring(0, name.indexOf('-')))).isEmpty()) {
        try {
          Folders.delete(folder);
        } catch (IOException e) {
          // It belongs to another user.
        }
      }
    }
  }

  /**
   * Compiles once.
   *
   * @throws CompilationException also if the compiler exceeds its time or memory
   */
  void compile(
      CompilerProcess.Request request,
      CompilerProcess.Answer answer,
      Sandbox sandbox,
      Duration atMost)
      throws CompilationException, InterruptedException, IOException {
    try (CompilerProcess compiler = take(sandbox)) {
      FutureTask<@Nullable Void> task =
          new FutureTask<>(
              () -> {
                compiler.exchange(request, answer);
                return null;
              });
      Thread thread = new Thread(task, "sitaf-javac");
      thread.setDaemon(true);
      thread.start();
      task.get(atMost.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      throw new CompilationException(
          "the compilation did not finish within " + atMost.toSeconds() + " s", List.of());
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof CompilationException failure) {
        throw failure;
      }
      if (cause instanceof IOException failure) {
        throw failure;
      }
      throw new IOException("the Java compiler cannot be used: " + cause, cause);
    }
  }
}
