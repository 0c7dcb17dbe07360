package org.sitaf.agent.simulation;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The simulation bridge of this source tree. Tests that need it are skipped with a message if it is
 * not set up.
 */
public final class RealBridge {
  private RealBridge() {}

  /** The command that starts it. */
  public static List<String> command() {
    @Nullable String python = System.getProperty("sitaf.bridge.python");
    assumeTrue(
        python != null && !python.isBlank(),
        "skipped: no simulation bridge, set -Dsitaf.bridge.python");
    assumeTrue(
        Files.isExecutable(Path.of(python)), "skipped: no simulation bridge, missing " + python);
    return List.of(python, "-m", "sitaf_bridge");
  }
}
