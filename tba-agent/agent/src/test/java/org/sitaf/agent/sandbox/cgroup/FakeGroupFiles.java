package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/** A folder that behaves like a version 2 hierarchy of the kernel, as far as the agent uses it. */
final class FakeGroupFiles extends GroupFiles {
  private static final Map<String, String> FILES =
      Map.of(
          "memory.max", "max",
          "memory.swap.max", "max",
          "memory.oom.group", "0",
          "memory.events", "oom 0\noom_kill 0",
          "pids.max", "max",
          "cpu.weight", "100",
          "cgroup.procs", "",
          "cgroup.kill", "");

  final Path root;

  FakeGroupFiles(Path root, String controllers) throws IOException {
    this.root = root;
    Files.writeString(root.resolve("cgroup.controllers"), controllers + "\n");
    Files.writeString(root.resolve("cgroup.subtree_control"), "");
    Files.writeString(root.resolve("cgroup.procs"), "");
  }

  @Override
  void create(Path group) throws IOException {
    super.create(group);
    Set<String> controllers = new LinkedHashSet<>(lines(root.resolve("cgroup.subtree_control")));
    for (Map.Entry<String, String> file : FILES.entrySet()) {
      String controller = file.getKey().substring(0, file.getKey().indexOf('.'));
      if (controller.equals("cgroup") || controllers.contains(controller)) {
        Files.writeString(group.resolve(file.getKey()), file.getValue());
      }
    }
  }

  @Override
  void write(Path file, String value) throws IOException {
    switch (file.getFileName().toString()) {
      case "cgroup.procs" -> move(file, value);
      case "cgroup.subtree_control" -> {
        if (!members(file.getParent()).isEmpty()) {
          throw new IOException("Device or resource busy");
        }
        List<String> enabled = new ArrayList<>(lines(file));
        enabled.add(value.substring(1));
        Files.write(file, enabled);
      }
      case "cgroup.kill" -> Files.writeString(file.resolveSibling("cgroup.procs"), "");
      default -> {
        if (!Files.exists(file)) {
          throw new IOException("Permission denied: " + file);
        }
        super.write(file, value);
      }
    }
  }

  private void move(Path file, String process) throws IOException {
    try (Stream<Path> all = Files.walk(root)) {
      for (Path other : all.filter(p -> p.endsWith("cgroup.procs")).toList()) {
        List<String> left = new ArrayList<>(lines(other));
        if (left.remove(process)) {
          Files.write(other, left);
        }
      }
    }
    List<String> members = new ArrayList<>(lines(file));
    members.add(process);
    Files.write(file, members);
  }

  @Override
  void remove(Path group) throws IOException {
    if (!members(group).isEmpty()) {
      throw new IOException("Device or resource busy");
    }
    try (Stream<Path> files = Files.list(group)) {
      files.forEach(FakeGroupFiles::delete);
    }
    super.remove(group);
  }

  private static void delete(Path file) {
    try {
      Files.delete(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
