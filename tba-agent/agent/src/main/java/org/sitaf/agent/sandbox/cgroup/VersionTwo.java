package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.UserDefinedFileAttributeView;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Control groups of version 2 in a subtree that is this process's own, as systemd delegates it. A
 * group that has groups in it has no processes, so this process moves into one itself.
 */
final class VersionTwo implements ControlGroups {
  /** The group of this process and of what it starts unconfined. */
  static final String SELF = "sitaf-self";

  /** How systemd marks what it has delegated. */
  private static final String DELEGATED = "delegate";

  private final GroupFiles files;
  private final Path parent;
  private final List<String> controllers;
  private final Owner owner;
  private final AtomicInteger next = new AtomicInteger();

  private VersionTwo(GroupFiles files, Path parent, List<String> controllers, Owner owner) {
    this.files = files;
    this.parent = parent;
    this.controllers = List.copyOf(controllers);
    this.owner = owner;
  }

  static Optional<ControlGroups> find(GroupFiles files, Hierarchies hierarchies, Owner owner)
      throws IOException {
    Optional<Path> own = hierarchies.unified();
    if (own.isEmpty()) {
      return Optional.empty();
    }
    boolean moved = String.valueOf(own.get().getFileName()).equals(SELF);
    Path parent = moved ? own.get().getParent() : own.get();
    return moved || isOurs(files, parent) ? in(files, parent, owner) : Optional.empty();
  }

  /** Takes a delegated group; empty where it has none of the controllers. */
  static Optional<ControlGroups> in(GroupFiles files, Path parent, Owner owner) throws IOException {
    if (!Hierarchies.isWritable(parent)) {
      return Optional.empty();
    }
    List<String> available =
        new ArrayList<>(
            List.of(
                String.join(" ", files.lines(parent.resolve("cgroup.controllers"))).split(" ")));
    available.retainAll(CONTROLLERS);
    if (available.isEmpty()) {
      return Optional.empty();
    }
    Leftovers.sweep(files, parent);
    Path self = parent.resolve(SELF);
    if (!Files.isDirectory(self)) {
      files.make(self);
    }
    for (long member : files.members(parent)) {
      files.tryWrite(self.resolve(ControlGroup.MEMBERS), Long.toString(member));
    }
    List<String> enabled = new ArrayList<>();
    for (String controller : available) {
      if (files.tryWrite(parent.resolve("cgroup.subtree_control"), "+" + controller)) {
        enabled.add(controller);
      }
    }
    return enabled.isEmpty()
        ? Optional.empty()
        : Optional.of(new VersionTwo(files, parent, enabled, owner));
  }

  /**
   * Whether nobody else manages this group: it is marked as delegated, or nothing is in it but this
   * process and what it started. Root could write any group, and would move others' processes.
   */
  private static boolean isOurs(GroupFiles files, Path group) {
    UserDefinedFileAttributeView marks =
        Files.getFileAttributeView(group, UserDefinedFileAttributeView.class);
    try {
      if (marks != null && marks.list().contains(DELEGATED)) {
        return true;
      }
    } catch (IOException e) {
      // Kernels before 5.7 keep no marks there.
    }
    Set<Long> own =
        ProcessHandle.current().descendants().map(ProcessHandle::pid).collect(Collectors.toSet());
    own.add(ProcessHandle.current().pid());
    return own.containsAll(files.members(group));
  }

  @Override
  public String description() {
    return "control groups (v2) for " + String.join(", ", controllers);
  }

  @Override
  public boolean bindMemory() {
    return controllers.contains("memory");
  }

  @Override
  public boolean shareProcessors() {
    return controllers.contains("cpu");
  }

  @Override
  public ControlGroup make(GroupLimits limits) throws IOException {
    Path folder = parent.resolve(owner.nameOf(next.getAndIncrement()));
    files.make(folder);
    @Nullable Path events = null;
    try {
      if (bindMemory()) {
        files.write(folder.resolve("memory.max"), Long.toString(limits.memoryBytes()));
        files.tryWrite(folder.resolve("memory.swap.max"), "0");
        files.tryWrite(folder.resolve("memory.oom.group"), "1");
        events = folder.resolve("memory.events");
      }
      if (controllers.contains("pids")) {
        files.write(folder.resolve("pids.max"), Integer.toString(limits.processes()));
      }
      // Each group has the same share of the processors: cpu.weight is 100 from the beginning.
    } catch (IOException e) {
      new ControlGroup(files, List.of(folder), null).remove();
      throw e;
    }
    return new ControlGroup(files, List.of(folder), events);
  }
}
