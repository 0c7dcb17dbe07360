package org.sitaf.agent.executor;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.SimulatorEndpoint;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.debug.DebugOrder;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.core.timing.Timing;

/**
 * Input of an execution.
 *
 * @param files absolute folder of the application's files, including suite and world
 * @param suiteFile the suite document for the test application
 * @param directory of the executor, for the test application's working folder; created if missing
 * @param coverage holds one folder of coverage data per process; created when needed
 * @param recording folder of the recordings of cases; created when needed; null for none
 * @param world null if the activity has none
 * @param timing how often the call of each case is repeated; null for never
 * @param variation of the processes; see {@link org.sitaf.agent.toolchain.ProcessPlace}
 * @param debugging the order to debug the first process; null for none
 */
public record ExecutionRequest(
    CompiledApplication application,
    Sandbox sandbox,
    Path files,
    TestSuite suite,
    Path suiteFile,
    Path directory,
    Path coverage,
    @Nullable Path recording,
    @Nullable World world,
    @Nullable Timing timing,
    Limits limits,
    int variation,
    @Nullable DebugOrder debugging) {
  public ExecutionRequest {
    Objects.requireNonNull(application);
    Objects.requireNonNull(sandbox);
    Objects.requireNonNull(files);
    Objects.requireNonNull(suite);
    Objects.requireNonNull(suiteFile);
    Objects.requireNonNull(directory);
    Objects.requireNonNull(coverage);
    Objects.requireNonNull(limits);
  }

  /** A request without an order to debug. */
  public ExecutionRequest(
      CompiledApplication application,
      Sandbox sandbox,
      Path files,
      TestSuite suite,
      Path suiteFile,
      Path directory,
      Path coverage,
      @Nullable Path recording,
      @Nullable World world,
      @Nullable Timing timing,
      Limits limits,
      int variation) {
    this(
        application,
        sandbox,
        files,
        suite,
        suiteFile,
        directory,
        coverage,
        recording,
        world,
        timing,
        limits,
        variation,
        null);
  }

  /** The same request for a process that is not debugged. */
  ExecutionRequest withoutDebugging() {
    return debugging == null
        ? this
        : new ExecutionRequest(
            application,
            sandbox,
            files,
            suite,
            suiteFile,
            directory,
            coverage,
            recording,
            world,
            timing,
            limits,
            variation);
  }

  /**
   * A shard of the cases, with its own folder.
   *
   * @param number from 1
   */
  ExecutionRequest part(int number, List<TestCase> cases) throws IOException {
    Path own = Files.createDirectories(directory.resolve("part-" + number));
    TestSuite part = suite.withCases(cases);
    return new ExecutionRequest(
        application,
        sandbox,
        files,
        part,
        written(part, own),
        own,
        coverage,
        // Each process runs as another user, who owns what it writes to.
        recording == null ? null : recordingOfShard(recording, number),
        world,
        timing,
        limits,
        variation,
        debugging);
  }

  /**
   * Other cases of the same application, with their own folder. They are not repeated, and their
   * coverage is kept apart.
   *
   * @param folder name of the folder
   * @param recordings folder of their recordings; null for none
   */
  public ExecutionRequest apart(String folder, TestSuite others, @Nullable Path recordings)
      throws IOException {
    Path own = Files.createDirectories(directory.resolve(folder));
    return new ExecutionRequest(
        application,
        sandbox,
        files,
        others,
        written(others, own),
        own,
        own.resolve("coverage"),
        recordings,
        world,
        null,
        limits,
        variation,
        null);
  }

  private static Path written(TestSuite suite, Path folder) throws IOException {
    Path file = folder.resolve("suite.xml");
    try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
      TestSuiteXml.write(suite.withoutExpected(), out);
    }
    return file;
  }

  static Path recordingOfShard(Path recording, int number) {
    return recording.resolve("part-" + number);
  }

  /** Opens the simulator endpoint of the next process; null if the activity has no world. */
  @Nullable SimulatorEndpoint newEndpoint() throws IOException, InterruptedException {
    return world == null ? null : world.simulator().open();
  }

  Path newCoverageFolder() throws IOException {
    return Files.createTempDirectory(Files.createDirectories(coverage), "process");
  }

  /**
   * The simulation of the activity.
   *
   * @param description absolute path of the world description; its folder holds the world's files
   * @param simulator provides each process with its own endpoint
   */
  public record World(Path description, Endpoints simulator) {}

  /** Provides endpoints of a simulator. */
  @FunctionalInterface
  public interface Endpoints {
    /**
     * Opens an endpoint, of a new simulator if the last one has ended.
     *
     * @throws IOException if no simulator answers and none can be started
     */
    SimulatorEndpoint open() throws IOException, InterruptedException;
  }
}
