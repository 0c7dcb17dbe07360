package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/** Control groups of version 1: one hierarchy per controller, writable for root only. */
final class VersionOne implements ControlGroups {
  private static final String MEMORY = "memory";

  private final GroupFiles files;
  private final Map<String, Path> parents;
  private final GroupOwner owner;
  private final AtomicInteger next = new AtomicInteger();

  private VersionOne(GroupFiles files, Map<String, Path> parents, GroupOwner owner) {
    this.files = files;
    this.parents = parents;
    this.owner = owner;
  }

  static Optional<ControlGroups> find(GroupFiles files, Hierarchies hierarchies, GroupOwner owner)
      throws IOException {
    Map<String, Path> parents = new TreeMap<>();
    for (String controller : hierarchies.writable(CONTROLLERS)) {
      Path parent = hierarchies.controllers().get(controller);
      parents.put(controller, parent);
      StaleGroups.removeAll(files, parent);
    }
    return parents.isEmpty()
        ? Optional.empty()
        : Optional.of(new VersionOne(files, parents, owner));
  }

  @Override
  public String description() {
    return "control groups (v1) for " + String.join(", ", parents.keySet());
  }

  @Override
  public boolean limitsMemory() {
    return parents.containsKey(MEMORY);
  }

  @Override
  public boolean sharesCpu() {
    return parents.containsKey("cpu");
  }

  @Override
  public ControlGroup create(GroupLimits limits) throws IOException {
    String name = owner.nameOf(next.getAndIncrement());
    List<Path> created = new ArrayList<>();
    @Nullable Path events = null;
    @Nullable Path cpu = null;
    try {
      for (Map.Entry<String, Path> parent : parents.entrySet()) {
        Path folder = parent.getValue().resolve(name);
        files.create(folder);
        created.add(folder);
        switch (parent.getKey()) {
          case MEMORY -> {
            limitMemory(folder, limits.memoryBytes());
            events = folder.resolve("memory.oom_control");
          }
          case "pids" ->
              files.write(folder.resolve("pids.max"), Integer.toString(limits.processes()));
          // All groups have the same default weight.
          default -> cpu = folder;
        }
      }
    } catch (IOException e) {
      new ControlGroup(files, created, null, null).remove();
      throw e;
    }
    return new ControlGroup(files, created, events, cpu);
  }

  private void limitMemory(Path folder, long bytes) throws IOException {
    String value = Long.toString(bytes);
    files.write(folder.resolve("memory.limit_in_bytes"), value);
    // Limit memory and swap together; if the kernel does not count swap, disable swapping.
    if (!files.tryWrite(folder.resolve("memory.memsw.limit_in_bytes"), value)) {
      files.tryWrite(folder.resolve("memory.swappiness"), "0");
    }
  }
}
