package org.sitaf.agent.sandbox.seccomp;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A system call filter in a file that another process can open. The file is deleted but kept open,
 * so nobody can change or remove it, and it disappears with this process.
 */
public final class SystemCallFilter {
  private static final Path OWN_FILES = Path.of("/proc/self/fd");
  private static final Map<List<Boolean>, SystemCallFilter> FILTERS = new ConcurrentHashMap<>();

  private final Path path;

  /** Keeps the deleted file readable. */
  @SuppressWarnings("unused")
  private final FileChannel open;

  private SystemCallFilter(Path path, FileChannel open) {
    this.path = path;
    this.open = open;
  }

  /**
   * The filter for this machine; empty if its architecture is not supported.
   *
   * @param memoryIsCounted whether a control group counts all memory; otherwise shared memory that
   *     belongs to no process is blocked
   * @param cpuIsShared whether a control group distributes processor time; otherwise new sessions
   *     are blocked
   * @throws IOException if the filter cannot be written
   */
  public static synchronized Optional<SystemCallFilter> of(
      boolean memoryIsCounted, boolean cpuIsShared) throws IOException {
    Optional<Architecture> architecture = Architecture.ofThisMachine();
    if (architecture.isEmpty()) {
      return Optional.empty();
    }
    List<Boolean> kind = List.of(memoryIsCounted, cpuIsShared);
    SystemCallFilter filter = FILTERS.get(kind);
    if (filter == null) {
      List<SystemCallRule> rules = new ArrayList<>(SystemCallRules.ALWAYS);
      if (!memoryIsCounted) {
        rules.addAll(SystemCallRules.WITHOUT_MEMORY_GROUP);
      }
      if (!cpuIsShared) {
        rules.addAll(SystemCallRules.WITHOUT_CPU_GROUP);
      }
      filter = write(FilterProgram.of(architecture.get(), rules));
      FILTERS.put(kind, filter);
    }
    return Optional.of(filter);
  }

  /** Path by which processes of this user can open the filter. */
  public Path path() {
    return path;
  }

  private static SystemCallFilter write(byte[] program) throws IOException {
    Path file = Files.createTempFile("sitaf", ".bpf").toRealPath();
    try {
      FileChannel channel =
          FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE);
      channel.write(ByteBuffer.wrap(program));
      return new SystemCallFilter(descriptorOf(file), channel);
    } finally {
      Files.delete(file);
    }
  }

  private static Path descriptorOf(Path file) throws IOException {
    try (DirectoryStream<Path> descriptors = Files.newDirectoryStream(OWN_FILES)) {
      for (Path descriptor : descriptors) {
        if (isLinkTo(descriptor, file)) {
          return Path.of(
              "/proc",
              Long.toString(ProcessHandle.current().pid()),
              "fd",
              descriptor.getFileName().toString());
        }
      }
    }
    throw new IOException("the system call filter is not listed in " + OWN_FILES);
  }

  private static boolean isLinkTo(Path descriptor, Path file) {
    try {
      return Files.readSymbolicLink(descriptor).equals(file);
    } catch (IOException e) {
      // The descriptor was closed.
      return false;
    }
  }
}
