package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.stream.Stream;

/**
 * Ends a process that uses, with all that it started, more memory than it may. The kernel's own
 * limits bind either one process or need rights over control groups that an agent seldom has.
 */
final class MemoryWatch implements Runnable {
  private static final Duration PERIOD = Duration.ofMillis(100);

  private final Process process;
  private final int limitMiB;
  private final Runnable onExcess;

  private MemoryWatch(Process process, int limitMiB, Runnable onExcess) {
    this.process = process;
    this.limitMiB = limitMiB;
    this.onExcess = onExcess;
  }

  /** Watches until the process ends. */
  static void over(Process process, int limitMiB, Runnable onExcess) {
    Thread thread = new Thread(new MemoryWatch(process, limitMiB, onExcess), "sitaf-memory");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void run() {
    try {
      while (!process.waitFor(PERIOD.toMillis(), java.util.concurrent.TimeUnit.MILLISECONDS)) {
        if (usedKiB() > (long) limitMiB << 10) {
          onExcess.run();
          return;
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private long usedKiB() {
    return Stream.concat(Stream.of(process.toHandle()), process.descendants())
        .mapToLong(handle -> usedKiB(handle.pid()))
        .sum();
  }

  private static long usedKiB(long pid) {
    try (Stream<String> lines =
        Files.lines(Path.of("/proc", Long.toString(pid), "status"), StandardCharsets.ISO_8859_1)) {
      return lines
          .filter(line -> line.startsWith("RssAnon:") || line.startsWith("RssShmem:"))
          .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
          .sum();
    } catch (IOException | java.io.UncheckedIOException e) {
      // It ended meanwhile.
      return 0;
    }
  }
}
