package org.sitaf.agent.executor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.suite.TestSuite;

/**
 * What to execute.
 *
 * @param files folder of the application's files, absolute; suite and world lie in it
 * @param suiteFile the suite as a document, for the test application
 * @param directory the executor's own, for the results file and the working folder of the test
 *     application; created
 * @param world null where the activity has none
 */
public record ExecutionRequest(
    CompiledApplication application,
    Sandbox sandbox,
    Path files,
    TestSuite suite,
    Path suiteFile,
    Path directory,
    @Nullable World world,
    Limits limits) {
  public ExecutionRequest {
    Objects.requireNonNull(application);
    Objects.requireNonNull(sandbox);
    Objects.requireNonNull(files);
    Objects.requireNonNull(suite);
    Objects.requireNonNull(suiteFile);
    Objects.requireNonNull(directory);
    Objects.requireNonNull(limits);
  }

  /** Where processes leave what they reached of the component, a folder a process. */
  public Path coverage() {
    return directory.resolve("coverage");
  }

  Path newCoverageFolder() throws IOException {
    return Files.createTempDirectory(Files.createDirectories(coverage()), "process");
  }

  /**
   * The simulation of the activity.
   *
   * @param description the world description, absolute; the world's files are those of its folder
   * @param simulator asked before each process, as its simulator may have to be started anew
   */
  public record World(Path description, SimulatorTarget simulator) {}

  /** Where a simulator answers. */
  @FunctionalInterface
  public interface SimulatorTarget {
    /**
     * A gRPC target.
     *
     * @throws IOException when no simulator answers and none can be started
     */
    String get() throws IOException, InterruptedException;
  }
}
