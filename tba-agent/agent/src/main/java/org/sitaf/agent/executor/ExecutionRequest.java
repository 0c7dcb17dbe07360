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
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;

/**
 * What to execute.
 *
 * @param files folder of the application's files, absolute; suite and world lie in it
 * @param suiteFile the suite as a document, for the test application
 * @param directory the executor's own, for the working folder of the test application; created
 * @param coverage where processes leave what they reached of the component, a folder a process;
 *     created when it is needed
 * @param recording where processes leave what moved in each case; created when it is needed; null
 *     where it is not asked for
 * @param world null where the activity has none
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
    Limits limits) {
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

  /**
   * A part of the cases, in a folder of its own.
   *
   * @param number from 1
   */
  ExecutionRequest part(int number, List<TestCase> cases) throws IOException {
    Path own = Files.createDirectories(directory.resolve("part-" + number));
    TestSuite part =
        new TestSuite(
            suite.name(),
            suite.description(),
            suite.modelName(),
            suite.generation(),
            suite.parameters(),
            cases);
    Path file = own.resolve("suite.xml");
    try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
      TestSuiteXml.write(part, out);
    }
    return new ExecutionRequest(
        application, sandbox, files, part, file, own, coverage, recording, world, limits);
  }

  /** What the next process reaches of the simulator; null where the activity has no world. */
  @Nullable SimulatorEndpoint newEndpoint() throws IOException, InterruptedException {
    return world == null ? null : world.simulator().open();
  }

  Path newCoverageFolder() throws IOException {
    return Files.createTempDirectory(Files.createDirectories(coverage), "process");
  }

  /**
   * The simulation of the activity.
   *
   * @param description the world description, absolute; the world's files are those of its folder
   * @param simulator asked before each process, each of which gets an endpoint of its own
   */
  public record World(Path description, Endpoints simulator) {}

  /** Where processes get their way to a simulator. */
  @FunctionalInterface
  public interface Endpoints {
    /**
     * Opens an endpoint, of a fresh simulator where the last one is gone.
     *
     * @throws IOException if no simulator answers and none can be started
     */
    SimulatorEndpoint open() throws IOException, InterruptedException;
  }
}
