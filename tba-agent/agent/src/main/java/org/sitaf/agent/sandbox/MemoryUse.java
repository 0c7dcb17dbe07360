package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The memory of a process and all its descendants, read from {@code /proc}: private and shared
 * memory, page tables, and an upper bound for the buffers of open sockets and pipes.
 */
final class MemoryUse {
  private static final Path PROC = Path.of("/proc");
  private static final Set<String> COUNTED =
      Set.of("RssAnon", "RssShmem", "VmSwap", "VmPTE", "HugetlbPages");

  /** Below this number, open descriptors are not counted: ordinary programs have that many. */
  private static final int FREE_DESCRIPTORS = 128;

  /** Default buffer size of a socket whose peer does not read. */
  private static final long SOCKET_KIB = 208;

  private static final long PIPE_KIB = 64;
  private static final long OTHER_KIB = 1;

  /**
   * Not every kernel lists the children of a thread; without the list, all processes are searched.
   */
  private static final boolean LISTS_CHILDREN =
      Files.exists(
          Path.of("/proc/self/task", Long.toString(ProcessHandle.current().pid()), "children"));

  private MemoryUse() {}

  static long kibOf(long root) {
    long sum = 0;
    Set<Long> seen = new HashSet<>(List.of(root));
    Deque<Long> open = new ArrayDeque<>(seen);
    while (!open.isEmpty()) {
      Path process = PROC.resolve(Long.toString(open.remove()));
      sum += resident(process) + buffers(process);
      for (long child : children(process)) {
        if (seen.add(child)) {
          open.add(child);
        }
      }
    }
    return sum;
  }

  private static long resident(Path process) {
    try (Stream<String> lines =
        Files.lines(process.resolve("status"), StandardCharsets.ISO_8859_1)) {
      return lines
          .filter(line -> COUNTED.contains(line.substring(0, Math.max(0, line.indexOf(':')))))
          .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
          .sum();
    } catch (IOException | java.io.UncheckedIOException e) {
      // The process has ended.
      return 0;
    }
  }

  private static long buffers(Path process) {
    String[] names = process.resolve("fd").toFile().list();
    if (names == null || names.length <= FREE_DESCRIPTORS) {
      return 0;
    }
    long sum = 0;
    for (String name : names) {
      try {
        String target = Files.readSymbolicLink(process.resolve("fd").resolve(name)).toString();
        sum +=
            target.startsWith("socket:")
                ? SOCKET_KIB
                : target.startsWith("pipe:") ? PIPE_KIB : OTHER_KIB;
      } catch (IOException e) {
        // The descriptor was closed.
      }
    }
    return sum;
  }

  /** Each thread lists its own children; orphans belong to the first process of the namespace. */
  private static Set<Long> children(Path process) {
    if (!LISTS_CHILDREN) {
      return ProcessHandle.of(Long.parseLong(process.getFileName().toString()))
          .map(handle -> handle.children().map(ProcessHandle::pid).collect(Collectors.toSet()))
          .orElse(Set.of());
    }
    Set<Long> children = new HashSet<>();
    try (DirectoryStream<Path> threads = Files.newDirectoryStream(process.resolve("task"))) {
      for (Path thread : threads) {
        for (String child : content(thread.resolve("children")).split(" ")) {
          if (!child.isBlank()) {
            children.add(Long.parseLong(child.strip()));
          }
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      // The process has ended.
    }
    return children;
  }

  private static String content(Path file) {
    try {
      return Files.readString(file, StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      return "";
    }
  }
}
