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
 * User ids for confined processes if the agent runs as root. Each process gets its own user id, and
 * each agent of a host its own range, because the kernel counts processes per user. A file lock
 * reserves the range, so it is free again when the agent's process ends.
 */
final class SandboxUsers {
  /**
   * Above the ids that distributions assign, and above 847000 to 847999, which earlier releases use
   * without a lock.
   */
  private static final int FIRST_USER = 848_000;

  private static final int RANGE = 1000;
  private static final int RANGES = 100;
  private static final Path CLAIMS = Path.of("/run/sitaf");
  private static final Path PROC = Path.of("/proc");

  private static @Nullable SandboxUsers ofThisProcess;

  private final int first;
  private final int count;

  /** Holds the reserved range. */
  @SuppressWarnings("unused")
  private final FileLock claim;

  private final Set<Integer> inUse = new HashSet<>();
  private int next;

  private SandboxUsers(int first, int count, FileLock claim) {
    this.first = first;
    this.count = count;
    this.claim = claim;
  }

  /** The range of this process, reserved at the first call. */
  static synchronized SandboxUsers ofThisProcess() throws IOException {
    if (ofThisProcess == null) {
      ofThisProcess = claim(CLAIMS, FIRST_USER, RANGE, RANGES);
    }
    return ofThisProcess;
  }

  /**
   * Reserves the first free range.
   *
   * @param folder folder of the lock files, shared by all agents of the host
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
        users.killProcessesOf(user -> users.owns(user));
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
      // Another object of this process holds it.
      return null;
    }
  }

  int first() {
    return first;
  }

  int last() {
    return first + count - 1;
  }

  /** Returns a user id that no process uses. */
  synchronized int acquire() throws IOException {
    for (int i = 0; i <= count; i++) {
      if (next == count) {
        // Ids are reused from here on: kill processes that may be left.
        next = 0;
        killProcessesOf(user -> owns(user) && !inUse.contains(user));
      }
      int user = first + next++;
      if (inUse.add(user)) {
        return user;
      }
    }
    throw new IOException("more than " + count + " confined processes at a time");
  }

  /** Releases the id of a process that has ended. */
  synchronized void release(int user) {
    inUse.remove(user);
  }

  private boolean owns(int user) {
    return user >= first && user <= last();
  }

  private void killProcessesOf(IntPredicate users) throws IOException {
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
      // The process has ended.
      return -1;
    }
  }
}
