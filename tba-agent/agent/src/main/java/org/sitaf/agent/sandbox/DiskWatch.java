package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sitaf.agent.spool.SystemTool;

/**
 * Ends a process that writes, with all that it started, more than it may. The kernel's own limit
 * binds each file by itself; a quota needs rights over a file system that an agent seldom has.
 */
final class DiskWatch {
  private static final long SHORTEST_PAUSE_MS = 100;
  private static final long LONGEST_PAUSE_MS = 1000;

  /** Looking takes at most this part of the time. */
  private static final int SHARE = 5;

  /** Deleted files are looked for in each such round only; nobody needs them in a hurry. */
  private static final int ROUNDS = 5;

  /** A process may be hidden for a moment while it becomes another program. */
  private static final int MOST_HIDDEN = 4;

  private static final int MOST_OPENED = 50;
  private static final Duration OPENING = Duration.ofSeconds(2);

  private final List<Path> own;
  private final List<Path> shared;
  private final DiskLimits limits;
  private final TreeSize before;
  private int opened;
  private int hiddenRounds;

  private DiskWatch(Confinement confinement) {
    this.own = Stream.of(confinement.working(), confinement.temporary()).distinct().toList();
    this.shared = confinement.writable();
    this.limits = DiskLimits.of(confinement.limits());
    this.before = new TreeSize(new DiskLimits(Integer.MAX_VALUE, Integer.MAX_VALUE)).with(shared);
  }

  /**
   * Of a process that is about to start. What lies in its own folders before counts, as it may be
   * what a process before it left; what lies in the others does not.
   */
  static DiskWatch of(Confinement confinement) {
    return new DiskWatch(confinement);
  }

  /**
   * Watches until the process ends.
   *
   * @param onExcess receives which limit it broke
   */
  void over(Process process, Consumer<String> onExcess) {
    Thread thread = new Thread(() -> watch(process, onExcess), "sitaf-disk");
    thread.setDaemon(true);
    thread.start();
  }

  private void watch(Process process, Consumer<String> onExcess) {
    long pause = SHORTEST_PAUSE_MS;
    try {
      for (int round = 1; !process.waitFor(pause, TimeUnit.MILLISECONDS); round++) {
        long begun = System.nanoTime();
        String excess = excess(process, round % ROUNDS == 0);
        if (!excess.isEmpty()) {
          onExcess.accept(excess);
          return;
        }
        long tookMs = (System.nanoTime() - begun) / 1_000_000;
        pause = Math.min(LONGEST_PAUSE_MS, Math.max(SHORTEST_PAUSE_MS, SHARE * tookMs));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Which limit is broken; empty for none. */
  private String excess(Process process, boolean deletedToo) throws InterruptedException {
    DiskLimits most =
        new DiskLimits(
            (int) Math.min(Integer.MAX_VALUE, limits.mebibytes() + (before.bytes() >> 20) + 1),
            limits.files() + before.files());
    TreeSize now = new TreeSize(most).with(own).with(shared);
    long bytes = now.bytes() - before.bytes();
    if (deletedToo) {
      UnlinkedFiles deleted = deletedFiles(process);
      bytes += deleted.bytes();
      hiddenRounds = deleted.areHidden() ? hiddenRounds + 1 : 0;
    }
    if (bytes > limits.bytes()) {
      return "it wrote more than " + limits.mebibytes() + " MiB of files";
    }
    if (now.files() - before.files() > limits.files()) {
      return "it wrote more than " + limits.files() + " files";
    }
    if (now.isTooDeep()) {
      return "it nested folders more than " + TreeSize.DEEPEST + " deep";
    }
    if (hiddenRounds == MOST_HIDDEN) {
      return "it hides from the agent which files it has open";
    }
    return now.closed().isEmpty() || open(now.closed())
        ? ""
        : "it keeps folders from being looked into";
  }

  private UnlinkedFiles deletedFiles(Process process) {
    List<Path> folders = new ArrayList<>(own);
    folders.addAll(shared);
    return UnlinkedFiles.of(
        Stream.concat(Stream.of(process.toHandle()), process.descendants()), folders);
  }

  /**
   * Gives the agent's user the rights on its own folders back; false where it had to too often. A
   * link that comes in a folder's place gets no one else a right.
   */
  private boolean open(List<Path> folders) throws InterruptedException {
    if (++opened > MOST_OPENED) {
      return false;
    }
    List<String> command = new ArrayList<>(List.of("chmod", "u+rwx", "--"));
    folders.stream().limit(MOST_OPENED).forEach(folder -> command.add(folder.toString()));
    try {
      SystemTool.run(command, OPENING);
    } catch (IOException e) {
      // Gone meanwhile, or another try is needed.
    }
    return true;
  }
}
