package org.sitaf.agent.simulation;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class SimulatorTest {
  private static final byte[] MJCF =
      "<mujoco><worldbody><geom name=\"floor\" type=\"plane\" size=\"1 1 1\"/></worldbody></mujoco>"
          .getBytes(UTF_8);
  private static final byte[] WORLD =
      """
      mjcf: w.xml
      parameters:
        Friction: {unit: "1", range: [0, 2], default: 1, bind: {set: geom.floor.friction.0}}
      devices: {}
      observations: {}
      """
          .getBytes(UTF_8);

  @TempDir private Path directory;

  @Test
  void aBridgeIsKeptForTheNextBuildAndSaysWhatItIs() throws Exception {
    try (Simulator simulator = Simulator.started(RealBridge.command(), directory)) {
      String target = simulator.target();
      assertThat(target).startsWith("unix:/");
      try (SimulatorClient client = new SimulatorClient(target)) {
        assertThat(client.version()).matches("sitaf-bridge \\S+ \\(MuJoCo \\S+\\)");
        client.check("w.world.yaml", Map.of("w.world.yaml", WORLD, "w.xml", MJCF));
      }
      assertThat(simulator.target()).isEqualTo(target);
    }
  }

  @Test
  void aBridgeThatDiedIsReplacedByAnother() throws Exception {
    try (Simulator simulator = Simulator.started(RealBridge.command(), directory)) {
      String target = simulator.target();
      bridges().forEach(SimulatorTest::killAndWait);

      assertThat(simulator.target()).isNotEqualTo(target);
      try (SimulatorClient client = new SimulatorClient(simulator.target())) {
        assertThat(client.version()).startsWith("sitaf-bridge");
      }
    }
  }

  @Test
  void aBridgeEndsWithItsOwner() throws Exception {
    try (Simulator simulator = Simulator.started(RealBridge.command(), directory)) {
      simulator.target();
      assertThat(bridges()).isNotEmpty();
    }
    assertThat(bridges()).isEmpty();
  }

  @Test
  void aWorldThatTheSimulatorRefusesIsToldWithItsMessage() throws Exception {
    try (Simulator simulator = Simulator.started(RealBridge.command(), directory);
        SimulatorClient client = new SimulatorClient(simulator.target())) {
      assertThatThrownBy(
              () ->
                  client.check(
                      "w.world.yaml",
                      Map.of(
                          "w.world.yaml",
                          WORLD,
                          "w.xml",
                          "<mujoco><oops/></mujoco>".getBytes(UTF_8))))
          .isInstanceOf(WorldException.class)
          .hasMessageContaining("oops");
    }
  }

  @Test
  void aFolderWithALongPathGetsASocketElsewhere() throws Exception {
    Path deep = directory.resolve("d".repeat(100));
    try (Simulator simulator = Simulator.started(RealBridge.command(), deep);
        SimulatorClient client = new SimulatorClient(simulator.target())) {
      assertThat(simulator.target().length()).isLessThan(107);
      assertThat(client.version()).startsWith("sitaf-bridge");
    }
  }

  @Test
  void aCommandThatDoesNotExistIsToldAsSuch() {
    try (Simulator simulator = Simulator.started(List.of("/no/such/python"), directory)) {
      assertThatThrownBy(simulator::target)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("cannot be started with '/no/such/python'");
    }
  }

  @Test
  void aCommandThatEndsAtOnceIsToldWithItsLastLine() throws Exception {
    Path script = Files.writeString(directory.resolve("s.sh"), "echo no module >&2; exit 4\n");
    try (Simulator simulator =
        Simulator.started(List.of("sh", script.toString()), directory.resolve("b"))) {
      assertThatThrownBy(simulator::target)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("exit code 4")
          .hasMessageContaining("no module");
    }
  }

  @Test
  void aSimulatorThatIsNotThereIsNoFaultOfTheWorld() {
    try (SimulatorClient client = new SimulatorClient("unix:" + directory.resolve("nobody"))) {
      assertThatThrownBy(client::version)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("does not answer");
    }
  }

  @Test
  void withoutASimulatorTheMessageSaysWhatToDo() {
    try (Simulator none = Simulator.none()) {
      assertThatThrownBy(none::target)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("--bridge-command");
    }
  }

  private static void killAndWait(ProcessHandle process) {
    process.destroyForcibly();
    process.onExit().join();
  }

  private List<ProcessHandle> bridges() {
    return ProcessHandle.current()
        .descendants()
        .filter(ProcessHandle::isAlive)
        .filter(handle -> handle.info().commandLine().orElse("").contains("--stop-with-stdin"))
        .toList();
  }
}
