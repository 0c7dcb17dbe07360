package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.Set;
import java.util.function.IntPredicate;
import org.jspecify.annotations.Nullable;

/**
 * The users that confined processes run as where the agent is root: each process has its own, and
 * each agent of a host a range of its own, as the kernel counts the processes of a user over all
 * agents. The range is kept by a lock on a file, so it is free again when this process has ended.
 */
final class SandboxUsers {
  /**
   * Beyond those that distributions give away, and beyond 847000 to 847999, which releases before
   * this one use without asking.
   */
  private static final int FIRST_USER = 848_000;

  private static final int RANGE = 1000;
  private static final int RANGES = 100;
  private static final Path CLAIMS = Path.of("/run/sitaf");
  private static final Path PROC = Path.of("/proc");

  private static @Nullable SandboxUsers ofThisProcess;

  private final int first;
  private final int count;

  /** Keeps the claim. */
  @SuppressWarnings("unused")
  private final FileLock claim;

  private final Set<Integer> taken = new HashSet<>();
  private int next;

  private SandboxUsers(int first, int count, FileLock claim) {
    this.first = first;
    this.count = count;
    this.claim = claim;
  }

  /** Those of this process; claimed when they are needed for the first time. */
  static synchronized SandboxUsers ofThisProcess() throws IOException {
    if (ofThisProcess == null) {
      ofThisProcess = claim(CLAIMS, FIRST_USER, RANGE, RANGES);
    }
    return ofThisProcess;
  }

  /**
   * Claims the first range that nobody has.
   *
   * @param folder for the claims, the same one for all agents of the host
   */
  static SandboxUsers claim(Path folder, int firstUser, int range, int ranges) throws IOException {
    Files.createDirectories(folder);
    for (int i = 0; i < ranges; i++) {
      int first = firstUser + i * range;
      FileChannel channel =
          FileChannel.open(
              folder.resolve("users-" + first + ".lock"),
              StandardOpenOption.CREATE,
              StandardOpenOption.WRITE);
      FileLock lock = lock(channel);
      if (lock != null) {
        SandboxUsers users = new SandboxUsers(first, range, lock);
        users.endProcessesOf(user -> users.owns(user));
        return users;
      }
      channel.close();
    }
    throw new IOException(
        "all "
            + ranges
            + " ranges of sandbox users are in use, see "
            + folder
            + "; stop an agent of this host");
  }

  private static @Nullable FileLock lock(FileChannel channel) throws IOException {
    try {
      return channel.tryLock();
    } catch (OverlappingFileLockException e) {
      // Somebody in this process has it.
      return null;
    }
  }

  int first() {
    return first;
  }

  int last() {
    return first + count - 1;
  }

  /** A user of which no process runs. */
  synchronized int take() throws IOException {
    for (int i = 0; i <= count; i++) {
      if (next == count) {
        // From here on they are used again: nothing of those before may be left.
        next = 0;
        endProcessesOf(user -> owns(user) && !taken.contains(user));
      }
      int user = first + next++;
      if (taken.add(user)) {
        return user;
      }
    }
    throw new IOException("more than " + count + " confined processes at a time");
  }

  /** Gives back a user whose process has ended. */
  synchronized void release(int user) {
    taken.remove(user);
  }

  private boolean owns(int user) {
    return user >= first && user <= last();
  }

  private void endProcessesOf(IntPredicate users) throws IOException {
    try (DirectoryStream<Path> processes = Files.newDirectoryStream(PROC, "[0-9]*")) {
      for (Path process : processes) {
        if (users.test(userOf(process))) {
          ProcessHandle.of(Long.parseLong(process.getFileName().toString()))
              .ifPresent(ProcessHandle::destroyForcibly);
        }
      }
    } catch (DirectoryIteratorException e) {
      throw e.getCause();
    }
  }

  private static int userOf(Path process) {
    try {
      return (Integer) Files.getAttribute(process, "unix:uid");
    } catch (IOException e) {
      // It ended meanwhile.
      return -1;
    }
  }
}
