package org.sitaf.agent.simulation;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.protobuf.ByteString;
import io.grpc.Grpc;
import io.grpc.InsecureChannelCredentials;
import io.grpc.ManagedChannel;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.sim.v1.CreateSessionRequest;
import org.sitaf.sim.v1.ReadDevicesRequest;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.VirtualHardwareGrpc;
import org.sitaf.sim.v1.WorldSource;

@Tag("slow")
@Timeout(300)
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

  private Simulator started(int builds) throws IOException {
    return Simulator.started(RealBridge.command(), directory, SandboxMode.AUTO.open(), builds);
  }

  private static void check(BuildSimulator simulator) throws Exception {
    simulator.check("w.world.yaml", Map.of("w.world.yaml", WORLD, "w.xml", MJCF), Set.of());
  }

  @Test
  void eachBuildHasItsOwnBridge() throws Exception {
    try (Simulator simulators = started(3)) {
      String first;
      try (BuildSimulator simulator = simulators.forBuild()) {
        first = simulator.target();
        assertThat(first).startsWith("unix:/");
        assertThat(simulator.version()).matches("sitaf-bridge \\S+ \\(MuJoCo \\S+\\)");
        assertThat(simulator.description()).contains("serves this build only");
        check(simulator);
        assertThat(simulator.target()).isEqualTo(first);
        try (BuildSimulator another = simulators.forBuild()) {
          assertThat(another.target()).isNotEqualTo(first);
        }
      }
      assertThat(Path.of(first.substring("unix:".length()))).doesNotExist();
      try (BuildSimulator next = simulators.forBuild()) {
        assertThat(next.target()).isNotEqualTo(first);
      }
    }
  }

  @Test
  void startsABridgeAheadForAnExpectedBuild() throws Exception {
    try (Simulator simulators = started(1)) {
      awaitBridges();
      List<ProcessHandle> waiting = outermost(bridges());
      assertThat(waiting).hasSize(1);
      try (BuildSimulator simulator = simulators.forBuild()) {
        simulator.target();
        assertThat(outermost(bridges())).isEqualTo(waiting);
      }
      assertThat(bridges()).isEmpty();
    }
  }

  @Test
  void replacesAnIdleBridgeThatDied() throws Exception {
    try (Simulator simulators = started(1)) {
      awaitBridges();
      bridges().forEach(SimulatorTest::killAndWait);
      try (BuildSimulator simulator = simulators.forBuild()) {
        assertThat(simulator.version()).startsWith("sitaf-bridge");
      }
    }
  }

  @Test
  void replacesABridgeThatDiedWhileItWasStartedAhead() throws Exception {
    Path started = directory.resolve("started");
    Path script =
        Files.writeString(
            directory.resolve("s.sh"),
            "[ -e '%s' ] && exec \"$@\"; touch '%s'; exit 137\n".formatted(started, started));
    List<String> command = new ArrayList<>(List.of("sh", script.toString()));
    command.addAll(RealBridge.command());
    try (Simulator simulators =
            Simulator.started(command, directory.resolve("b"), Sandbox.none(), 1);
        BuildSimulator simulator = simulators.forBuild()) {
      assertThat(simulator.version()).startsWith("sitaf-bridge");
    }
  }

  @Test
  void anEndpointHasASocketOfOperationsUntilItIsClosed() throws Exception {
    try (Simulator simulators = started(1);
        BuildSimulator simulator = simulators.forBuild()) {
      check(simulator);
      Path operations;
      try (SimulatorEndpoint endpoint = simulator.open()) {
        operations = Path.of(endpoint.target().substring("unix:".length()) + ".ops");
        SocketChannel.open(UnixDomainSocketAddress.of(operations)).close();
      }
      assertThat(operations).doesNotExist();
    }
  }

  @Test
  void anEndpointOffersOnlyTheWorldOfTheBuild() throws Exception {
    try (Simulator simulators = started(1);
        BuildSimulator simulator = simulators.forBuild()) {
      check(simulator);
      try (SimulatorEndpoint endpoint = simulator.open();
          SimulatorClient client = new SimulatorClient(endpoint.target())) {
        assertThat(endpoint.target()).isNotEqualTo(simulator.target());
        assertThat(endpoint.isShared()).isFalse();
        assertThat(endpoint.hasEnded()).isFalse();
        assertThat(endpoint.end()).isEmpty();
        assertThat(
                client
                    .check("w.world.yaml", Map.of("w.world.yaml", WORLD, "w.xml", MJCF), Set.of())
                    .digest())
            .hasSize(64);
        byte[] other = "<mujoco/>".getBytes(UTF_8);
        assertThatThrownBy(
                () ->
                    client.check(
                        "w.world.yaml", Map.of("w.world.yaml", WORLD, "w.xml", other), Set.of()))
            .hasMessageContaining("PERMISSION_DENIED");
        assertThatThrownBy(() -> client.openEndpoint("e9", "0", null, null))
            .hasMessageContaining("UNIMPLEMENTED");
      }
    }
  }

  @Test
  void aCameraRendersTheSameImageInTheSandbox() throws Exception {
    byte[] mjcf =
        ("<mujoco><worldbody><light pos=\"0 0 3\"/><geom type=\"plane\" size=\"1 1 1\"/>"
                + "<camera name=\"c\" pos=\"0 0 2\"/></worldbody></mujoco>")
            .getBytes(UTF_8);
    byte[] world =
        "mjcf: w.xml\ndevices:\n  c: {kind: camera, camera: c, width: 32, height: 24}\n"
            .getBytes(UTF_8);
    Map<String, byte[]> files = Map.of("w.world.yaml", world, "w.xml", mjcf);
    String outside;
    try (Simulator simulators =
            Simulator.started(RealBridge.command(), directory, Sandbox.none(), 0);
        BuildSimulator simulator = simulators.forBuild()) {
      outside = picture(simulator, files);
    }
    try (Simulator simulators = started(0);
        BuildSimulator simulator = simulators.forBuild()) {
      assertThat(picture(simulator, files)).isEqualTo(outside);
    }
  }

  /** Digest of the camera image, or the status code if this machine cannot render. */
  private static String picture(BuildSimulator simulator, Map<String, byte[]> files)
      throws Exception {
    simulator.check("w.world.yaml", files, Set.of());
    WorldSource.Builder source = WorldSource.newBuilder().setDescription("w.world.yaml");
    files.forEach((path, content) -> source.putFiles(path, ByteString.copyFrom(content)));
    try (SimulatorEndpoint endpoint = simulator.open()) {
      ManagedChannel channel =
          Grpc.newChannelBuilder(endpoint.target(), InsecureChannelCredentials.create())
              .overrideAuthority("localhost")
              .build();
      try {
        String session =
            SimulationControlGrpc.newBlockingStub(channel)
                .createSession(CreateSessionRequest.newBuilder().setWorld(source).build())
                .getSessionId();
        ByteString seen =
            VirtualHardwareGrpc.newBlockingStub(channel)
                .readDevices(
                    ReadDevicesRequest.newBuilder().setSessionId(session).addDevices("c").build())
                .getState()
                .getReadings(0)
                .getImage()
                .getData();
        assertThat(seen.size()).isEqualTo(32 * 24 * 3);
        return Integer.toString(seen.hashCode());
      } catch (StatusRuntimeException e) {
        return e.getStatus().getCode().toString();
      } finally {
        channel.shutdownNow();
      }
    }
  }

  @Test
  void replacesABridgeThatDiedWithTheSameWorld() throws Exception {
    try (Simulator simulators = started(1);
        BuildSimulator simulator = simulators.forBuild()) {
      check(simulator);
      try (SimulatorEndpoint endpoint = simulator.open()) {
        bridges().forEach(SimulatorTest::killAndWait);
        assertThat(endpoint.end())
            .hasValueSatisfying(end -> assertThat(end.reason()).contains("exit code"));
        assertThat(endpoint.hasEnded()).isTrue();
      }
      try (SimulatorEndpoint endpoint = simulator.open();
          SimulatorClient client = new SimulatorClient(endpoint.target())) {
        assertThat(endpoint.end()).isEmpty();
        assertThat(
                client
                    .check("w.world.yaml", Map.of("w.world.yaml", WORLD, "w.xml", MJCF), Set.of())
                    .digest())
            .hasSize(64);
      }
    }
  }

  @Test
  void compilesAKnownWorldInTheBackground() throws Exception {
    try (Simulator simulators = started(2)) {
      for (int build = 0; build < 2; build++) {
        try (BuildSimulator simulator = simulators.forBuild()) {
          check(simulator);
          try (SimulatorEndpoint endpoint = simulator.open();
              SimulatorClient client = new SimulatorClient(endpoint.target())) {
            assertThat(
                    client
                        .check(
                            "w.world.yaml", Map.of("w.world.yaml", WORLD, "w.xml", MJCF), Set.of())
                        .stepNanos())
                .isPositive();
          }
        }
      }
    }
  }

  @Test
  void reportsTheMessageOfARejectedWorld() throws Exception {
    byte[] oops = "<mujoco><oops/></mujoco>".getBytes(UTF_8);
    try (Simulator simulators = started(0);
        BuildSimulator simulator = simulators.forBuild()) {
      assertThatThrownBy(
              () ->
                  simulator.check(
                      "w.world.yaml", Map.of("w.world.yaml", WORLD, "w.xml", oops), Set.of()))
          .isInstanceOf(WorldException.class)
          .hasMessageContaining("oops");
      check(simulator);
    }
  }

  @Test
  void createsTheSocketElsewhereIfThePathIsTooLong() throws Exception {
    Path deep = directory.resolve("d".repeat(100));
    try (Simulator simulators =
            Simulator.started(RealBridge.command(), deep, SandboxMode.AUTO.open(), 0);
        BuildSimulator simulator = simulators.forBuild()) {
      assertThat(simulator.target().length()).isLessThan(107);
      assertThat(simulator.version()).startsWith("sitaf-bridge");
    }
  }

  @Test
  void reportsAMissingCommand() throws Exception {
    try (Simulator simulators =
            Simulator.started(List.of("/no/such/python"), directory, Sandbox.none(), 1);
        BuildSimulator simulator = simulators.forBuild()) {
      assertThatThrownBy(simulator::target)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("cannot be started with '/no/such/python'");
    }
  }

  @Test
  void reportsTheLastLineOfACommandThatEnds() throws Exception {
    Path script = Files.writeString(directory.resolve("s.sh"), "echo no module >&2; exit 4\n");
    try (Simulator simulators =
            Simulator.started(
                List.of("sh", script.toString()),
                directory.resolve("b"),
                SandboxMode.AUTO.open(),
                0);
        BuildSimulator simulator = simulators.forBuild()) {
      assertThatThrownBy(simulator::target)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("exit code 4")
          .hasMessageContaining("no module");
    }
  }

  @Test
  void anUnreachableSimulatorIsNotAnErrorOfTheWorld() {
    try (SimulatorClient client = new SimulatorClient("unix:" + directory.resolve("missing"))) {
      assertThatThrownBy(client::version)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("does not answer");
    }
  }

  @Test
  void explainsHowToConfigureASimulator() {
    try (Simulator none = Simulator.none()) {
      assertThatThrownBy(none::forBuild)
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining("--bridge-command");
    }
  }

  private void awaitBridges() throws InterruptedException {
    for (int i = 0; i < 1000 && (bridges().isEmpty() || !hasSocket()); i++) {
      Thread.sleep(20);
    }
  }

  private boolean hasSocket() {
    try (Stream<Path> files = Files.walk(directory)) {
      return files.anyMatch(file -> file.endsWith("control"));
    } catch (IOException | java.io.UncheckedIOException e) {
      return false;
    }
  }

  private static void killAndWait(ProcessHandle process) {
    process.destroyForcibly();
    process.onExit().join();
  }

  /** Without the processes that a bridge starts, which may look like it for a moment. */
  private static List<ProcessHandle> outermost(List<ProcessHandle> processes) {
    return processes.stream()
        .filter(process -> process.parent().filter(processes::contains).isEmpty())
        .toList();
  }

  private List<ProcessHandle> bridges() {
    return ProcessHandle.current()
        .descendants()
        .filter(ProcessHandle::isAlive)
        .filter(handle -> handle.info().commandLine().orElse("").contains("--stop-with-stdin"))
        .toList();
  }
}
