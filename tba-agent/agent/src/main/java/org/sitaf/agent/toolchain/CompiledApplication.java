package org.sitaf.agent.toolchain;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.verdict.Coverage;

/** A test application that can be started, as often as needed and in several processes at once. */
public interface CompiledApplication {
  /** What starts it; the arguments of a test application are appended. */
  List<String> command(ProcessPlace place);

  /** Variables that its process needs. */
  default Map<String, String> environment(ProcessPlace place) {
    return Map.of();
  }

  /** Files and folders beyond the system's that its process reads, absolute. */
  List<Path> readable();

  /**
   * Where a process hangs, in one line, out of what it printed when it was asked for its stacks.
   */
  default Optional<String> whereItHangs(String stacks) {
    return Optional.empty();
  }

  /** Whether its processes record which lines of the component they reach. */
  default boolean recordsCoverage() {
    return false;
  }

  /**
   * What the processes of an execution reached, together.
   *
   * @param data holds a folder a process, each the {@link ProcessPlace#coverage()} of one
   */
  default Optional<Coverage> coverage(Path data) throws IOException, InterruptedException {
    return Optional.empty();
  }

  /** What its runtime takes of memory beyond what the profile grants the component. */
  default int overheadMiB() {
    return 64;
  }
}
