package org.sitaf.agent.build;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.ExecutionRequest.World;
import org.sitaf.agent.executor.SimulatorAddress;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.BuildSimulator;
import org.sitaf.agent.simulation.WorldException;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.fault.FaultKind;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.document.TestSuiteXml;

/**
 * Writes the files of an application and prepares its simulation.
 *
 * @param directory for the files of the application
 */
record Preparation(
    TestApplication application, Path directory, BuildSettings settings, BuildListener listener) {

  /**
   * Result of the preparation.
   *
   * @param simulator closed with the build; null if the activity has no world
   * @param bridge version of the simulator; empty if the activity has no world
   * @param signals of the cases, for trajectory conditions
   * @param hardware the devices that are not simulated
   */
  record Prepared(
      @Nullable World world,
      @Nullable BuildSimulator simulator,
      String bridge,
      CaseSignals signals,
      CaseHardware hardware)
      implements AutoCloseable {
    @Override
    public void close() {
      if (simulator != null) {
        simulator.close();
      }
    }
  }

  /**
   * Writes the application's files and lets the simulator check the world before anything is
   * compiled.
   */
  Prepared run(BuildLog log) throws IOException, InterruptedException, CompilationException {
    FileTree files = application.files();
    for (String path : files.paths()) {
      Path file = directory.resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, files.content(path).orElseThrow());
    }
    // The agent compares; a component that can read the expected values could return them.
    try (OutputStream suite = new BufferedOutputStream(Files.newOutputStream(suiteFile()))) {
      TestSuiteXml.write(application.suite().withoutExpected(), suite);
    }
    String world = application.activity().profile().world();
    CaseSignals signals = new CaseSignals(application, settings, listener);
    CaseHardware hardware = new CaseHardware(application, settings.devices());
    if (world == null) {
      return new Prepared(null, null, "", signals, hardware);
    }
    int slash = world.lastIndexOf('/');
    FileTree folder = application.activity().files().below(world.substring(0, slash + 1));
    Map<String, byte[]> worldFiles = new TreeMap<>();
    folder.paths().forEach(path -> worldFiles.put(path, folder.content(path).orElseThrow()));
    BuildSimulator simulator = settings.simulator().forBuild();
    boolean prepared = false;
    try {
      String version = simulator.version();
      long stepNanos = simulator.check(world.substring(slash + 1), worldFiles, saturations());
      signals.begin(simulator, stepNanos);
      hardware.begin(simulator, log);
      log.remark("world " + world + " on " + version);
      log.remark(simulator.description());
      requireReachable(simulator.target(), log);
      Path description = directory.resolve("activity").resolve(world);
      prepared = true;
      listener.simulated(simulator::motion);
      return new Prepared(
          new World(description, simulator::open), simulator, version, signals, hardware);
    } catch (WorldException e) {
      String message = String.valueOf(e.getMessage());
      throw new CompilationException(
          "the simulator rejects the world: " + message,
          List.of(SourceDiagnostic.ofFile("activity/" + world, message)));
    } finally {
      if (!prepared) {
        simulator.close();
      }
    }
  }

  /** The faults of which only the simulator knows whether the actuators can have them. */
  private Set<String> saturations() {
    return application.suite().parameters().stream()
        .map(CaseParameter::name)
        .filter(
            name -> FaultName.find(name).filter(f -> f.kind() == FaultKind.SATURATED).isPresent())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Access to a simulator over TCP requires network access for the component. */
  private void requireReachable(String target, BuildLog log) throws IOException {
    Sandbox sandbox = settings.sandbox();
    if (new SimulatorAddress(target).socket().isPresent() || sandbox.kind().equals(Sandbox.NONE)) {
      return;
    }
    String why =
        "the simulator is at " + target + "; with unix:PATH the component needs no network";
    if (sandbox.isRequired()) {
      throw new IOException("--sandbox=required: " + why);
    }
    log.remark("the component has network access: " + why);
  }

  /** The suite as the test application reads it, without expected values. */
  Path suiteFile() {
    return directory.resolve("suite.xml");
  }
}
