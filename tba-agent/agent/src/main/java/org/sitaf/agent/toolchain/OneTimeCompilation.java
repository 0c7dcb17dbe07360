package org.sitaf.agent.toolchain;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Reports the progress of a compilation that a machine needs once and that takes minutes: its
 * begin, and every few seconds how many of its files are compiled.
 */
public final class OneTimeCompilation implements AutoCloseable {
  private static final Duration PERIOD = Duration.ofSeconds(10);

  private final CountDownLatch closed = new CountDownLatch(1);

  private OneTimeCompilation() {}

  /**
   * Begins to report.
   *
   * @param progress receives sentences without a full stop; called from other threads, too
   * @param what is compiled, such as "the runtime of C++ nodes"
   * @param objects the folder in which the compiled files appear
   * @param total how many of them
   */
  public static OneTimeCompilation of(
      Consumer<String> progress, String what, Path objects, int total) {
    return of(progress, what, objects, total, PERIOD);
  }

  static OneTimeCompilation of(
      Consumer<String> progress, String what, Path objects, int total, Duration period) {
    progress.accept("compiling " + what + ", once on this machine");
    OneTimeCompilation compilation = new OneTimeCompilation();
    Thread watcher =
        new Thread(
            () -> compilation.watch(progress, what, objects, total, period),
            "compilation-progress");
    watcher.setDaemon(true);
    watcher.start();
    return compilation;
  }

  private void watch(
      Consumer<String> progress, String what, Path objects, int total, Duration period) {
    try {
      while (!closed.await(period.toMillis(), TimeUnit.MILLISECONDS)) {
        progress.accept(
            "compiling " + what + ": " + compiledIn(objects) + " of " + total + " files");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static long compiledIn(Path folder) {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".o") || name.endsWith(".gch"))
          .count();
    } catch (IOException | UncheckedIOException e) {
      return 0; // The compiler creates and removes files meanwhile.
    }
  }

  /** Ends the reports. */
  @Override
  public void close() {
    closed.countDown();
  }
}
