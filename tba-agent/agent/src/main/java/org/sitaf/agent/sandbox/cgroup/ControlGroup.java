package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** The control group of one confined process: one folder per hierarchy. */
public final class ControlGroup {
  /** Writing a process id moves the process into the group; reading lists its processes. */
  static final String MEMBERS = "cgroup.procs";

  /** No control group. */
  public static final ControlGroup NONE = new ControlGroup(new GroupFiles(), List.of(), null, null);

  /** The kernel runs processes of such a group only when no others need a processor. */
  private static final String IDLE = "cpu.idle";

  private static final String KILL = "cgroup.kill";
  private static final String KILLED = "oom_kill";
  private static final int MAX_ROUNDS = 100;
  private static final long ROUND_MILLIS = 2;

  private final GroupFiles files;
  private final List<Path> folders;
  private final @Nullable Path memoryEvents;
  private final @Nullable Path cpu;
  private boolean exceeded;
  private boolean removed;

  /**
   * A group that exists.
   *
   * @param memoryEvents file in which the kernel counts out-of-memory kills; null if memory is not
   *     counted
   * @param cpu folder of the group that shares processor time; null if it is not shared by groups
   */
  ControlGroup(
      GroupFiles files, List<Path> folders, @Nullable Path memoryEvents, @Nullable Path cpu) {
    this.files = Objects.requireNonNull(files);
    this.folders = List.copyOf(folders);
    this.memoryEvents = memoryEvents;
    this.cpu = cpu;
  }

  /** Files into which a process writes 0 to enter the group. */
  public List<Path> entrances() {
    return folders.stream().map(folder -> folder.resolve(MEMBERS)).toList();
  }

  /** Whether the kernel limits the memory of the group. */
  public boolean limitsMemory() {
    return memoryEvents != null;
  }

  /** Whether the kernel killed a process because the group exceeded its memory. */
  public synchronized boolean exceededMemory() {
    if (!removed && memoryEvents != null) {
      exceeded |= files.number(memoryEvents, KILLED) > 0;
    }
    return exceeded;
  }

  /**
   * Lets the group use only processor time that nobody else needs, or an equal share again. Without
   * effect before Linux 5.15.
   */
  public synchronized void setIdle(boolean idle) {
    if (cpu != null && !removed) {
      files.tryWrite(cpu.resolve(IDLE), idle ? "1" : "0");
    }
  }

  /** Kills all processes of the group, including those started meanwhile. */
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

  /** Removes the group and kills its processes; {@link #exceededMemory} stays valid. */
  public synchronized void remove() {
    exceededMemory();
    kill();
    for (int round = 0; round < MAX_ROUNDS && !removed; round++) {
      boolean gone = true;
      for (Path folder : folders) {
        try {
          files.remove(folder);
        } catch (IOException e) {
          // A killed process has not left the group yet.
          gone = false;
        }
      }
      removed = gone;
      if (!gone && !pause()) {
        return;
      }
    }
  }

  /** Returns whether to continue; false if the thread is interrupted (cancelled build). */
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
