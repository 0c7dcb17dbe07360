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
 * A filter of system calls, as a file that another process can open. The file has no name in any
 * folder: nobody can change it, nobody tidies it away, and it goes with this process.
 */
public final class SystemCallFilter {
  private static final Path OWN_FILES = Path.of("/proc/self/fd");
  private static final Map<List<Boolean>, SystemCallFilter> MADE = new ConcurrentHashMap<>();

  private final Path path;

  /** Keeps the file open, and so alive. */
  @SuppressWarnings("unused")
  private final FileChannel open;

  private SystemCallFilter(Path path, FileChannel open) {
    this.path = path;
    this.open = open;
  }

  /**
   * The filter for this machine; empty where its architecture is not in the table.
   *
   * @param memoryIsCounted whether a control group counts all memory, so that memory of no process
   *     may exist
   * @param processorsAreShared whether a control group shares the processors out, so that sessions
   *     may be opened
   * @throws IOException when it cannot be written
   */
  public static synchronized Optional<SystemCallFilter> of(
      boolean memoryIsCounted, boolean processorsAreShared) throws IOException {
    Optional<Architecture> architecture = Architecture.ofThisMachine();
    if (architecture.isEmpty()) {
      return Optional.empty();
    }
    List<Boolean> kind = List.of(memoryIsCounted, processorsAreShared);
    SystemCallFilter filter = MADE.get(kind);
    if (filter == null) {
      List<Refusal> refusals = new ArrayList<>(Refusals.ALWAYS);
      if (!memoryIsCounted) {
        refusals.addAll(Refusals.WHERE_MEMORY_IS_WATCHED);
      }
      if (!processorsAreShared) {
        refusals.addAll(Refusals.WHERE_SESSIONS_SHARE_PROCESSORS);
      }
      filter = written(FilterProgram.of(architecture.get(), refusals));
      MADE.put(kind, filter);
    }
    return Optional.of(filter);
  }

  /** Where processes of this user find it. */
  public Path path() {
    return path;
  }

  private static SystemCallFilter written(byte[] program) throws IOException {
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
    throw new IOException("the filter of system calls is not in " + OWN_FILES);
  }

  private static boolean isLinkTo(Path descriptor, Path file) {
    try {
      return Files.readSymbolicLink(descriptor).equals(file);
    } catch (IOException e) {
      // Closed meanwhile.
      return false;
    }
  }
}
