package org.sitaf.runtime;

import io.grpc.Server;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.TestCase;

/**
 * Runs a small test application once per installation. The classes that it loads are stored in a
 * class-data archive, which halves the start time of test applications.
 */
final class DryRun {
  private static final String SUITE =
      """
      <test_suite_data>
        <name>dry-run</name>
        <test_model_name>dry-run</test_model_name>
        <case_param_info>
          <param name="n" type="TDI" real_type="int"/>
          <param name="x" type="TDSD" real_type="double"/>
        </case_param_info>
        <case_list>
          <case no="1" class="valid"><value>1</value><value>1.5</value><expected>1.5</expected></case>
          <case no="2" class="valid"><value>1</value><value>2e0</value><expected>3</expected></case>
          <case no="3" class="valid"><value>2</value><value>3</value></case>
        </case_list>
      </test_suite_data>
      """;

  private DryRun() {}

  /** The component of the dry run. */
  public static final class Component {
    private final RangeSensor sensor;
    private int size;

    /** Takes the hardware, as components do. */
    public Component(Hardware hardware) {
      sensor = hardware.rangeSensor(DryRunSimulator.SENSOR);
    }

    /** A property with a setter. */
    public void setSize(int size) {
      this.size = size;
    }

    double measure(int times) {
      return times * size * sensor.range();
    }
  }

  /** A driver like the generated ones. */
  private static final class Driver extends SuiteDriver<Component> {
    private final TestRun run;

    Driver(TestRun run) {
      super(run, LifeCycle.CASE, "measure");
      this.run = run;
    }

    @Override
    protected Component createComponent() throws Exception {
      Component component = newComponent(Component.class);
      setProperty(component, "Size", "1");
      return component;
    }

    @Override
    protected void runCase(TestCase testCase, CaseResult result) throws Exception {
      int times = testCase.intValue("n");
      run.simulation().prepare(Map.of("x", testCase.doubleValue("x")), Duration.ZERO);
      Component component = component();
      stopwatch().start();
      double returned = component.measure(times);
      stopwatch().stop();
      result.record("return", returned);
      save(result);
    }
  }

  /** Takes no arguments; always ends with 0. */
  public static void main(String[] arguments) throws IOException {
    Path folder = Files.createTempDirectory("sitaf-dry-run");
    Path suite = Files.writeString(folder.resolve("suite.xml"), SUITE);
    Path world = Files.writeString(folder.resolve("none.world.yaml"), "mjcf: none.xml\n");
    Path results = Files.createFile(folder.resolve("results"));
    Server simulator = DryRunSimulator.listening();
    // Once with a server, and once with a Unix socket address as agents use it, without a server.
    for (String target :
        List.of("127.0.0.1:" + simulator.getPort(), "unix:" + folder.resolve("bridge"))) {
      TestRun.execute(
          new String[] {
            "--suite", suite.toString(),
            "--results", results.toString(),
            "--bridge", target,
            "--world", world.toString(),
            "--from", "1"
          },
          Driver::new);
    }
    simulator.shutdownNow();
    for (Path file : List.of(suite, world, results, folder)) {
      Files.delete(file);
    }
  }
}
