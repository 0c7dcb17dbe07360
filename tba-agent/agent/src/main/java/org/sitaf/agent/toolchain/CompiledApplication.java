package org.sitaf.agent.toolchain;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.verdict.Coverage;

/** A compiled test application, which can be started many times, also in parallel. */
public interface CompiledApplication {
  /** The command that starts it; the arguments of a test application are appended. */
  List<String> command(ProcessPlace place);

  /** Environment variables of its process. */
  default Map<String, String> environment(ProcessPlace place) {
    return Map.of();
  }

  /**
   * A process that was started with a place for debugging.
   *
   * @param pid its process id
   */
  default Debuggee debuggee(DebugPlace place, long pid) {
    throw new UnsupportedOperationException("its processes cannot be debugged");
  }

  /** Absolute paths that its process reads, in addition to the system's folders. */
  List<Path> readable();

  /** One line that tells where a process hangs, from the stack traces that it printed. */
  default Optional<String> hangLocation(String stacks) {
    return Optional.empty();
  }

  /** What ended a process, from the end of its error stream; empty if its last line says enough. */
  default Optional<String> crashCause(String errors) {
    return Optional.empty();
  }

  /**
   * The compiler's warnings about the user's own sources, one line each, as {@code
   * file:line:column: warning: message}.
   */
  default List<String> warnings() throws IOException {
    return List.of();
  }

  /** The packages that the component uses, with those that they need, in ascending order. */
  default List<ResolvedPackage> packages() {
    return List.of();
  }

  /** Whether its processes reserve address space far beyond the memory that they use. */
  default boolean reservesMemory() {
    return false;
  }

  /** Whether its processes record which lines of the component they execute. */
  default boolean recordsCoverage() {
    return false;
  }

  /**
   * The merged coverage of all processes of an execution.
   *
   * @param data holds one folder per process, its {@link ProcessPlace#coverage()}
   */
  default Optional<Coverage> coverage(Path data) throws IOException, InterruptedException {
    return Optional.empty();
  }

  /** Memory of the language runtime, in addition to the limit of the component. */
  default int overheadMiB() {
    return 64;
  }
}
