package org.sitaf.agent.toolchain.python.environment;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.core.activity.lock.ActivityLock;

/** Base of tests that create environments with packages of an index on this machine. */
abstract class PackagesTest {
  private static final Duration LIMIT = Duration.ofMinutes(4);

  @TempDir Path directory;
  LocalIndex index;
  Sandbox sandbox;
  Environments environments;

  @BeforeEach
  void startIndex() throws Exception {
    sandbox = SandboxMode.AUTO.open();
    index = new LocalIndex();
    environments = index.environments(directory, sandbox);
  }

  @AfterEach
  void stopIndex() {
    index.close();
  }

  /** The environment with packages of the index and wheels of an activity. */
  Path make(List<String> lines, List<Path> wheels, @Nullable ActivityLock lock) throws Exception {
    return environments.with(
        new Requirements(lines, "activity/component/requirements.txt", wheels, lock),
        Files.createTempDirectory(directory, "scratch"),
        LIMIT,
        sandbox);
  }

  /** The folder of packages in an environment. */
  static Path sitePackages(Path environment) throws Exception {
    try (var versions = Files.newDirectoryStream(environment.resolve("lib"), "python*")) {
      return versions.iterator().next().resolve("site-packages");
    }
  }
}
