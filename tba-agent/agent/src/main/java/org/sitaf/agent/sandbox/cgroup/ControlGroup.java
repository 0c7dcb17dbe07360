package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** The group of one confined process: a folder in each hierarchy that this machine has for it. */
public final class ControlGroup {
  /** Who writes here enters the group; who reads learns its processes. */
  static final String MEMBERS = "cgroup.procs";

  /** No group at all. */
  public static final ControlGroup NONE = new ControlGroup(new GroupFiles(), List.of(), null);

  private static final String KILL = "cgroup.kill";
  private static final String KILLED = "oom_kill";
  private static final int MAX_ROUNDS = 100;
  private static final long ROUND_MILLIS = 2;

  private final GroupFiles files;
  private final List<Path> folders;
  private final @Nullable Path memoryEvents;
  private boolean exceeded;
  private boolean removed;

  /**
   * A group that exists.
   *
   * @param memoryEvents file in which the kernel counts what it killed for want of memory; null
   *     where it counts no memory
   */
  ControlGroup(GroupFiles files, List<Path> folders, @Nullable Path memoryEvents) {
    this.files = Objects.requireNonNull(files);
    this.folders = List.copyOf(folders);
    this.memoryEvents = memoryEvents;
  }

  /** Files into which a process writes 0 to enter, with all that it will start. */
  public List<Path> entrances() {
    return folders.stream().map(folder -> folder.resolve(MEMBERS)).toList();
  }

  /** Whether the kernel bounds the memory of the group. */
  public boolean bindsMemory() {
    return memoryEvents != null;
  }

  /** Whether the kernel ended a process because the group needed more memory than it may. */
  public synchronized boolean exceededMemory() {
    if (!removed && memoryEvents != null) {
      exceeded |= files.number(memoryEvents, KILLED) > 0;
    }
    return exceeded;
  }

  /** Ends all its processes, and those that they start meanwhile. */
  public synchronized void kill() {
    for (int round = 0; round < MAX_ROUNDS && !removed; round++) {
      boolean empty = true;
      for (Path folder : folders) {
        List<Long> members = files.members(folder);
        empty &= members.isEmpty();
        if (!members.isEmpty() && !files.tryWrite(folder.resolve(KILL), "1")) {
          for (long member : members) {
            ProcessHandle.of(member).ifPresent(ProcessHandle::destroyForcibly);
          }
        }
      }
      if (empty || !pause()) {
        return;
      }
    }
  }

  /** Removes it with all that is still in it; what it said of its memory stays known. */
  public synchronized void remove() {
    exceededMemory();
    kill();
    for (int round = 0; round < MAX_ROUNDS && !removed; round++) {
      boolean gone = true;
      for (Path folder : folders) {
        try {
          files.remove(folder);
        } catch (IOException e) {
          // What was killed is still leaving.
          gone = false;
        }
      }
      removed = gone;
      if (!gone && !pause()) {
        return;
      }
    }
  }

  /** Whether to go on; the thread of a cancelled build may be interrupted, and waits no longer. */
  private static boolean pause() {
    try {
      Thread.sleep(ROUND_MILLIS);
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
