package org.sitaf.agent.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.grpc.Grpc;
import io.grpc.InsecureChannelCredentials;
import io.grpc.ManagedChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.Simulation;
import org.sitaf.runtime.simulation.SimulationException;
import org.sitaf.runtime.suite.TestCase;
import org.sitaf.sim.v1.GetStatisticsRequest;
import org.sitaf.sim.v1.OperationStatistics;
import org.sitaf.sim.v1.SimulationControlGrpc;

/**
 * The runtime of Java test applications prepares several cases at once in the simulation; the
 * results must equal those of cases that are prepared one by one.
 */
@Tag("slow")
@Timeout(300)
class PreparedAheadTest {
  private static final Duration SETTLE = Duration.ofMillis(25);

  /** All readings of a device, by the name of its kind. */
  private static final Map<String, BiFunction<Hardware, String, List<?>>> KINDS =
      Map.of(
          "range",
          (h, n) -> List.of(h.rangeSensor(n).range(), h.rangeSensor(n).maxRange()),
          "scan",
          (h, n) ->
              List.of(Arrays.toString(h.laserScanner(n).ranges()), h.laserScanner(n).maxRange()),
          "imu",
          (h, n) ->
              List.of(
                  h.imu(n).orientation(),
                  h.imu(n).angularVelocity(),
                  h.imu(n).linearAcceleration()),
          "encoder",
          (h, n) -> List.of(h.jointEncoder(n).position(), h.jointEncoder(n).velocity()),
          "contact",
          (h, n) -> List.of(h.contactSensor(n).isPressed(), h.contactSensor(n).force()),
          "magnetometer",
          (h, n) -> List.of(h.magnetometer(n).field()),
          "battery",
          (h, n) ->
              List.of(
                  h.battery(n).voltage(),
                  h.battery(n).current(),
                  h.battery(n).charge(),
                  h.battery(n).percentage()),
          "drive",
          (h, n) ->
              List.of(
                  h.differentialDrive(n).linear(),
                  h.differentialDrive(n).angular(),
                  h.differentialDrive(n).leftPosition(),
                  h.differentialDrive(n).rightPosition()),
          "line",
          (h, n) -> List.of(h.digitalLine(n).isHigh()));

  @TempDir private Path directory;

  private static Path example(String file) {
    Path world = Path.of(System.getProperty("sitaf.examples", ""), file);
    assumeTrue(Files.exists(world), "skipped: missing " + world);
    return world;
  }

  private static List<TestCase> cases(Map<String, List<String>> columns, int count) {
    return IntStream.range(0, count)
        .mapToObj(
            i -> {
              Map<String, String> values = new LinkedHashMap<>();
              columns.forEach((name, list) -> values.put(name, list.get(i % list.size())));
              return new TestCase(i + 1, true, values);
            })
        .toList();
  }

  private static Map<String, Double> parameters(TestCase testCase, Iterable<String> names) {
    Map<String, Double> values = new LinkedHashMap<>();
    names.forEach(name -> values.put(name, testCase.doubleValue(name)));
    return values;
  }

  /** The calls of a component in a case; returns what is compared. */
  private interface Component {
    void act(Simulation simulation, TestCase testCase);
  }

  /** The result of each case, or the reason why the simulator rejected it. */
  private static List<String> run(
      String target,
      Path world,
      List<TestCase> cases,
      List<String> names,
      List<String> observations,
      boolean ahead,
      Component component)
      throws Exception {
    Deque<TestCase> left = new ArrayDeque<>(cases);
    List<String> seen = new ArrayList<>();
    try (Simulation simulation =
        Simulation.open(
            target,
            world,
            7,
            new Stopwatch(),
            count -> ahead ? left.stream().limit(count).collect(Collectors.toList()) : List.of())) {
      while (!left.isEmpty()) {
        TestCase testCase = left.remove();
        try {
          simulation.prepare(parameters(testCase, names), SETTLE);
          component.act(simulation, testCase);
          StringBuilder all = new StringBuilder(readings(simulation.hardware()).toString());
          observations.forEach(o -> all.append(o).append('=').append(simulation.observation(o)));
          seen.add(all.append(simulation.hardware().time()).toString());
        } catch (SimulationException e) {
          assertThat(e.isLost()).as(e.getMessage()).isFalse();
          seen.add(e.getMessage());
        }
      }
    }
    return seen;
  }

  private static Map<String, List<?>> readings(Hardware hardware) {
    Map<String, List<?>> all = new TreeMap<>();
    for (String device : hardware.devices()) {
      KINDS.forEach(
          (kind, read) -> {
            try {
              all.put(device + " " + kind, read.apply(hardware, device));
            } catch (IllegalArgumentException e) {
              // The device is of another kind.
            }
          });
    }
    return all;
  }

  /** Compares both ways; returns how many cases were still prepared one by one. */
  private long assertSameResults(
      String file,
      Map<String, List<String>> columns,
      int count,
      List<String> observations,
      Component component)
      throws Exception {
    List<String> names = List.copyOf(columns.keySet());
    List<TestCase> cases = cases(columns, count);
    Path world = example(file);
    try (Simulator simulators =
            Simulator.started(RealBridge.command(), directory, Sandbox.none(), 0);
        BuildSimulator simulator = simulators.forBuild()) {
      String target = simulator.target();
      List<String> alone = run(target, world, cases, names, observations, false, component);
      long before = preparedAlone(target);
      List<String> ahead = run(target, world, cases, names, observations, true, component);
      assertThat(ahead).hasSize(count).isEqualTo(alone);
      assertThat(new HashSet<>(alone)).hasSizeGreaterThan(count / 2);
      return preparedAlone(target) - before;
    }
  }

  /** The number of cases that the simulator prepared one by one. */
  private static long preparedAlone(String target) {
    ManagedChannel channel =
        Grpc.newChannelBuilder(target, InsecureChannelCredentials.create()).build();
    try {
      return SimulationControlGrpc.newBlockingStub(channel)
          .getStatistics(GetStatisticsRequest.getDefaultInstance())
          .getOperationsList()
          .stream()
          .filter(o -> o.getRpc().equals("Prepare"))
          .mapToLong(OperationStatistics::getCount)
          .sum();
    } finally {
      channel.shutdownNow();
    }
  }

  private static List<String> evenly(double from, double to, int count) {
    return IntStream.range(0, count)
        .mapToObj(i -> Double.toString(from + (to - from) * i / (count - 1)))
        .toList();
  }

  @Test
  void allSensorsOfARobotHaveTheSameReadings() throws Exception {
    long alone =
        assertSameResults(
            "worlds/maze/maze.world.yaml",
            Map.of(
                "StartX", evenly(-1.2, 1.1, 100),
                "Heading", evenly(-3, 3, 7),
                "LidarNoise", evenly(0, 0.1, 3),
                "Charge", evenly(0, 1, 11)),
            100,
            List.of("robot_x", "robot_y", "robot_yaw", "speed_x", "bumped", "at_box"),
            (simulation, testCase) -> {});

    assertThat(alone).isZero();
  }

  @Test
  void casesWithEqualValuesGetTheSameWorld() throws Exception {
    List<TestCase> cases =
        cases(
            Map.of(
                "StartX", List.of("-1.0", "0.0", "-0.0", "1.0"),
                "LidarNoise", List.of("0.1", "0.05")),
            200);
    List<String> names = List.of("StartX", "LidarNoise");
    Path world = example("worlds/maze/maze.world.yaml");
    try (Simulator simulators =
            Simulator.started(RealBridge.command(), directory, Sandbox.none(), 0);
        BuildSimulator simulator = simulators.forBuild()) {
      String target = simulator.target();
      List<String> alone =
          run(target, world, cases, names, List.of("robot_x"), false, (s, c) -> {});
      long before = preparedAlone(target);
      List<String> ahead = run(target, world, cases, names, List.of("robot_x"), true, (s, c) -> {});

      assertThat(ahead).isEqualTo(alone);
      assertThat(preparedAlone(target)).isEqualTo(before);
    }
  }

  @Test
  void aRejectedCaseHasTheSameMessage() throws Exception {
    List<String> distances = new ArrayList<>(evenly(-0.5, 15, 400));
    distances.set(5, "20.5");
    distances.set(50, "21.5");
    distances.set(333, "NaN");
    long alone =
        assertSameResults(
            "ir-sensor/world/ir.world.yaml",
            Map.of("Distance", distances),
            400,
            List.of("robot_x"),
            (simulation, testCase) -> {});

    assertThat(alone).isBetween(3L, 40L);
  }

  @Test
  void aComponentThatUsesActuatorsGetsALiveSession() throws Exception {
    long alone =
        assertSameResults(
            "worlds/maze/maze.world.yaml",
            Map.of("StartX", evenly(-1.2, 1.1, 60)),
            60,
            List.of("robot_x", "speed_x"),
            (simulation, testCase) -> {
              if (testCase.no() % 7 == 3) {
                simulation.hardware().differentialDrive("base").drive(0.3, 0.5);
                simulation.hardware().sleep(Duration.ofMillis(100));
              }
            });

    assertThat(alone).isEqualTo(58);
  }

  @Test
  void simulationContinuesFromThePreparedState() throws Exception {
    long alone =
        assertSameResults(
            "worlds/maze/maze.world.yaml",
            Map.of("StartX", evenly(-1.2, 1.1, 40)),
            40,
            List.of("robot_x", "speed_x"),
            (simulation, testCase) -> simulation.advance(Duration.ofMillis(50)));

    assertThat(alone).isEqualTo(40);
  }

  @Test
  void anInvalidCommandIsAnErrorOfTheComponent() throws Exception {
    List<TestCase> cases = cases(Map.of("StartX", evenly(-1, 1, 10)), 10);
    try (Simulator simulators =
            Simulator.started(RealBridge.command(), directory, Sandbox.none(), 0);
        BuildSimulator simulator = simulators.forBuild();
        Simulation simulation =
            Simulation.open(
                simulator.target(),
                example("worlds/maze/maze.world.yaml"),
                7,
                new Stopwatch(),
                count -> cases)) {
      simulation.prepare(Map.of("StartX", -1.0), SETTLE);
      assertThatThrownBy(() -> simulation.hardware().differentialDrive("base").drive(Double.NaN, 0))
          .isInstanceOf(IllegalArgumentException.class);
    }
  }
}
