package org.sitaf.agent.simulation;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A bridge that is not managed by the agent, with and without endpoints. */
@Timeout(120)
class SharedSimulatorTest {
  private static final Map<String, byte[]> WORLD =
      Map.of(
          "empty.world.yaml",
          "mjcf: empty.xml\n".getBytes(UTF_8),
          "empty.xml",
          "<mujoco><worldbody/></mujoco>".getBytes(UTF_8));
  private static final Map<String, byte[]> ANOTHER =
      Map.of(
          "empty.world.yaml",
          "mjcf: empty.xml\n".getBytes(UTF_8),
          "empty.xml",
          "<mujoco model='other'><worldbody/></mujoco>".getBytes(UTF_8));

  @TempDir private Path directory;
  private Process bridge;

  @AfterEach
  void end() throws InterruptedException {
    if (bridge != null) {
      bridge.destroyForcibly().waitFor();
    }
  }

  private Simulator running(String... options) throws IOException {
    List<String> command = new ArrayList<>(RealBridge.command());
    command.addAll(List.of("serve", "--listen", "unix:" + directory.resolve("c")));
    command.addAll(List.of(options));
    bridge = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    BufferedReader output = bridge.inputReader(UTF_8);
    assertThat(output.readLine()).startsWith("listening unix:");
    return Simulator.running("unix:" + directory.resolve("c"));
  }

  private Simulator withEndpoints() throws IOException {
    return running("--endpoints", Files.createDirectory(directory.resolve("e")).toString());
  }

  private static void check(BuildSimulator simulator) throws Exception {
    simulator.check("empty.world.yaml", WORLD, Set.of());
  }

  @Test
  void withoutEndpointsAllBuildsUseItsAddressAndNothingIsSampled() throws Exception {
    try (Simulator shared = running();
        BuildSimulator simulator = shared.forBuild()) {
      check(simulator);
      assertThat(simulator.description()).endsWith("is shared with others");
      try (SimulatorEndpoint endpoint = simulator.open()) {
        assertThat(endpoint.target()).isEqualTo(simulator.target());
        assertThat(endpoint.isShared()).isTrue();
      }
      assertThatThrownBy(() -> simulator.sample(new SignalOrder(List.of("t"), false)))
          .isInstanceOf(SimulatorException.class)
          .hasMessageContaining(simulator.target())
          .hasMessageContaining("--endpoints FOLDER");
    }
  }

  @Test
  void anEndpointBelongsToOneProcessAndOffersItsWorldOnly() throws Exception {
    try (Simulator shared = withEndpoints();
        BuildSimulator one = shared.forBuild();
        BuildSimulator two = shared.forBuild()) {
      check(one);
      check(two);
      one.sample(new SignalOrder(List.of("t"), false));
      Path socket;
      try (SimulatorEndpoint first = one.open();
          SimulatorEndpoint second = two.open();
          SimulatorClient client = new SimulatorClient(first.target())) {
        socket = Path.of(first.target().substring("unix:".length()));
        assertThat(socket).exists();
        assertThat(second.target()).isNotEqualTo(first.target());
        assertThat(first.isShared()).isFalse();
        assertThat(first.end()).isEmpty();
        assertThat(client.check("empty.world.yaml", WORLD, Set.of()).stepNanos()).isPositive();
        assertThatThrownBy(() -> client.check("empty.world.yaml", ANOTHER, Set.of()))
            .hasMessageContaining("the world of its build only");
        // No case has run.
        assertThat(one.takeSignals(1)).isEmpty();
      }
      assertThat(socket).doesNotExist();
    }
  }

  @Test
  void theEndOfTheBridgeIsSeen() throws Exception {
    try (Simulator shared = withEndpoints();
        BuildSimulator simulator = shared.forBuild()) {
      check(simulator);
      try (SimulatorEndpoint endpoint = simulator.open()) {
        assertThat(endpoint.end()).isEmpty();
        bridge.destroyForcibly().waitFor();
        assertThat(endpoint.end())
            .hasValueSatisfying(
                end -> {
                  assertThat(end.reason()).contains("does not answer");
                  assertThat(end.byLimit()).isFalse();
                });
      }
      assertThatThrownBy(simulator::open).isInstanceOf(SimulatorException.class);
    }
  }
}
