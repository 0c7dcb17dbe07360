package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.sitaf.core.verdict.Coverage;

/** How the lines that a component executes are recorded. */
interface Recording {
  /** Python options that record into a folder, before the module. */
  default List<String> recorder(Path directory) {
    return List.of();
  }

  /** Environment variables by which a process records into a folder. */
  default Map<String, String> environment(Path directory) {
    return Map.of();
  }

  /**
   * Reads the recorded data, which untrusted processes wrote.
   *
   * @param data holds one folder per process
   */
  Coverage read(Path data) throws IOException, InterruptedException;
}
