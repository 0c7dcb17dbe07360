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
 * Compilers: one for each compilation, of which the next may be started ahead. None sees two
 * requests, so that nothing of one user's sources reaches another's classes.
 */
final class CompilerProcesses {
  private final CompilerSetup setup;
  private final Path directory;
  private final AtomicLong count = new AtomicLong();
  private @Nullable CompilerProcess ahead;
  private boolean stopped;

  /**
   * No compiler yet.
   *
   * @param directory for their files; several agents may share it
   */
  CompilerProcesses(CompilerSetup setup, Path directory) {
    this.setup = setup;
    this.directory = directory;
  }

  /** Starts the compiler of the next compilation, unless there is one. */
  synchronized void startAhead(Sandbox sandbox) throws IOException, InterruptedException {
    if (!stopped && (ahead == null || !ahead.isReadyIn(sandbox))) {
      endAhead();
      ahead = start(sandbox);
    }
  }

  /** Ends what was started ahead, and starts nothing ahead any more. */
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
    return taken;
  }

  private CompilerProcess start(Sandbox sandbox) throws IOException {
    String own = ProcessHandle.current().pid() + "-";
    if (count.get() == 0) {
      deleteLeftBehind(own);
    }
    return CompilerProcess.start(
        setup, sandbox, directory.resolve(own + System.nanoTime() + "-" + count.incrementAndGet()));
  }

  /** Folders of agents that are gone begin with the number of a process that is. */
  private void deleteLeftBehind(String own) throws IOException {
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
          // Another user's.
        }
      }
    }
  }

  /**
   * Compiles once.
   *
   * @throws CompilationException also when the compiler takes longer or more memory than it may
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
          "the compilation was given up after " + atMost.toSeconds() + " s", List.of());
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
