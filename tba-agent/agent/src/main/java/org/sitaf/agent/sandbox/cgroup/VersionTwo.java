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
 * Control groups of version 2 in a subtree that systemd delegated to this process. A group with
 * subgroups must not have processes, so this process moves into a subgroup.
 */
final class VersionTwo implements ControlGroups {
  /** The group of this process and of its unconfined children. */
  static final String SELF = "sitaf-self";

  /** Extended attribute by which systemd marks delegated groups. */
  private static final String DELEGATED = "delegate";

  private final GroupFiles files;
  private final Path parent;
  private final List<String> controllers;
  private final GroupOwner owner;
  private final AtomicInteger next = new AtomicInteger();

  private VersionTwo(GroupFiles files, Path parent, List<String> controllers, GroupOwner owner) {
    this.files = files;
    this.parent = parent;
    this.controllers = List.copyOf(controllers);
    this.owner = owner;
  }

  static Optional<ControlGroups> find(GroupFiles files, Hierarchies hierarchies, GroupOwner owner)
      throws IOException {
    Optional<Path> own = hierarchies.unified();
    if (own.isEmpty()) {
      return Optional.empty();
    }
    boolean moved = String.valueOf(own.get().getFileName()).equals(SELF);
    Path parent = moved ? own.get().getParent() : own.get();
    return moved || isOurs(files, parent) ? takeOver(files, parent, owner) : Optional.empty();
  }

  /** Takes over a delegated group; empty if it has no usable controller. */
  static Optional<ControlGroups> takeOver(GroupFiles files, Path parent, GroupOwner owner)
      throws IOException {
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
    StaleGroups.removeAll(files, parent);
    Path self = parent.resolve(SELF);
    if (!Files.isDirectory(self)) {
      files.create(self);
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
   * Whether nobody else manages this group: systemd marked it as delegated, or it holds only this
   * process and its children. Root can write any group, and would otherwise move processes of
   * others.
   */
  private static boolean isOurs(GroupFiles files, Path group) {
    UserDefinedFileAttributeView marks =
        Files.getFileAttributeView(group, UserDefinedFileAttributeView.class);
    try {
      if (marks != null && marks.list().contains(DELEGATED)) {
        return true;
      }
    } catch (IOException e) {
      // Kernels before 5.7 have no attributes there.
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
  public boolean limitsMemory() {
    return controllers.contains("memory");
  }

  @Override
  public boolean sharesCpu() {
    return controllers.contains("cpu");
  }

  @Override
  public ControlGroup create(GroupLimits limits) throws IOException {
    Path folder = parent.resolve(owner.nameOf(next.getAndIncrement()));
    files.create(folder);
    @Nullable Path events = null;
    try {
      if (limitsMemory()) {
        files.write(folder.resolve("memory.max"), Long.toString(limits.memoryBytes()));
        files.tryWrite(folder.resolve("memory.swap.max"), "0");
        files.tryWrite(folder.resolve("memory.oom.group"), "1");
        events = folder.resolve("memory.events");
      }
      if (controllers.contains("pids")) {
        files.write(folder.resolve("pids.max"), Integer.toString(limits.processes()));
      }
      // cpu: all groups have the same default weight.
    } catch (IOException e) {
      new ControlGroup(files, List.of(folder), null, null).remove();
      throw e;
    }
    return new ControlGroup(files, List.of(folder), events, sharesCpu() ? folder : null);
  }
}
