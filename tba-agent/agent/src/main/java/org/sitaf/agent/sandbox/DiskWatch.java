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
 * Kills a process that, with all that it started, writes more than allowed. The kernel can limit
 * single files only, and a quota needs rights that an agent seldom has.
 */
final class DiskWatch {
  private static final long SHORTEST_PAUSE_MS = 100;
  private static final long LONGEST_PAUSE_MS = 1000;

  /** Pause between two checks, as a multiple of the duration of a check. */
  private static final int PAUSE_FACTOR = 5;

  /** Deleted files are searched in every n-th check only, because that is slow. */
  private static final int DELETED_FILES_PERIOD = 5;

  /** A process may be unreadable for a moment while it executes another program. */
  private static final int MAX_HIDDEN_CHECKS = 4;

  private static final int MAX_PERMISSION_FIXES = 50;
  private static final Duration CHMOD_TIMEOUT = Duration.ofSeconds(2);

  private final List<Path> own;
  private final List<Path> shared;
  private final DiskLimits limits;
  private final TreeSize before;
  private int permissionFixes;
  private int hiddenChecks;

  private DiskWatch(Confinement confinement) {
    this.own = Stream.of(confinement.working(), confinement.temporary()).distinct().toList();
    this.shared = confinement.writable();
    this.limits = DiskLimits.of(confinement.limits());
    this.before = new TreeSize(new DiskLimits(Integer.MAX_VALUE, Integer.MAX_VALUE)).with(shared);
  }

  /**
   * Measures the folders of a process that is about to start. Files that exist in its own folders
   * count against the limit, because an earlier process of the same component may have left them;
   * files in shared folders do not.
   */
  static DiskWatch of(Confinement confinement) {
    return new DiskWatch(confinement);
  }

  /**
   * Checks until the process ends.
   *
   * @param onExcess receives a message about the exceeded limit
   */
  void start(Process process, Consumer<String> onExcess) {
    Thread thread = new Thread(() -> watch(process, onExcess), "sitaf-disk");
    thread.setDaemon(true);
    thread.start();
  }

  private void watch(Process process, Consumer<String> onExcess) {
    long pause = SHORTEST_PAUSE_MS;
    try {
      for (int check = 1; !process.waitFor(pause, TimeUnit.MILLISECONDS); check++) {
        long start = System.nanoTime();
        String excess = excess(process, check % DELETED_FILES_PERIOD == 0);
        if (!excess.isEmpty()) {
          onExcess.accept(excess);
          return;
        }
        long elapsedMs = (System.nanoTime() - start) / 1_000_000;
        pause = Math.min(LONGEST_PAUSE_MS, Math.max(SHORTEST_PAUSE_MS, PAUSE_FACTOR * elapsedMs));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** A message about the exceeded limit; empty for none. */
  private String excess(Process process, boolean countDeleted) throws InterruptedException {
    DiskLimits max =
        new DiskLimits(
            (int) Math.min(Integer.MAX_VALUE, limits.mebibytes() + (before.bytes() >> 20) + 1),
            limits.files() + before.files());
    TreeSize now = new TreeSize(max).with(own).with(shared);
    long bytes = now.bytes() - before.bytes();
    if (countDeleted) {
      UnlinkedFiles deleted = deletedFiles(process);
      bytes += deleted.bytes();
      hiddenChecks = deleted.areHidden() ? hiddenChecks + 1 : 0;
    }
    if (bytes > limits.bytes()) {
      return "it wrote more than " + limits.mebibytes() + " MiB of files";
    }
    if (now.files() - before.files() > limits.files()) {
      return "it wrote more than " + limits.files() + " files";
    }
    if (now.isTooDeep()) {
      return "it nested folders more than " + TreeSize.MAX_DEPTH + " deep";
    }
    if (hiddenChecks == MAX_HIDDEN_CHECKS) {
      return "it prevents the agent from listing its open files";
    }
    return now.unreadable().isEmpty() || makeReadable(now.unreadable())
        ? ""
        : "it prevents the agent from reading its folders";
  }

  private UnlinkedFiles deletedFiles(Process process) {
    List<Path> folders = new ArrayList<>(own);
    folders.addAll(shared);
    return UnlinkedFiles.of(
        Stream.concat(Stream.of(process.toHandle()), process.descendants()), folders);
  }

  /**
   * Restores the permissions of the agent's user on its own folders; returns false after too many
   * attempts. {@code chmod} does not follow a link that replaced a folder during the listing.
   */
  private boolean makeReadable(List<Path> folders) throws InterruptedException {
    if (++permissionFixes > MAX_PERMISSION_FIXES) {
      return false;
    }
    List<String> command = new ArrayList<>(List.of("chmod", "u+rwx", "--"));
    folders.stream().limit(MAX_PERMISSION_FIXES).forEach(folder -> command.add(folder.toString()));
    try {
      SystemTool.run(command, CHMOD_TIMEOUT);
    } catch (IOException e) {
      // The folder is gone; otherwise the next check tries again.
    }
    return true;
  }
}
