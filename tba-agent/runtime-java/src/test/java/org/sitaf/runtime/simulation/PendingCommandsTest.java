package org.sitaf.runtime.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.grpc.Grpc;
import io.grpc.InsecureServerCredentials;
import io.grpc.Server;
import io.grpc.Status;
import io.grpc.stub.StreamObserver;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.actuator.DifferentialDrive;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.sim.v1.CommandBound;
import org.sitaf.sim.v1.CommandNumber;
import org.sitaf.sim.v1.CreateSessionRequest;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.DeviceDescription;
import org.sitaf.sim.v1.JointState;
import org.sitaf.sim.v1.PrepareRequest;
import org.sitaf.sim.v1.PrepareResponse;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.StepSimulationRequest;
import org.sitaf.sim.v1.StepSimulationResponse;
import org.sitaf.sim.v1.VirtualHardwareGrpc;
import org.sitaf.sim.v1.WorldDescription;
import org.sitaf.sim.v1.WorldState;
import org.sitaf.sim.v1.WriteDevicesRequest;
import org.sitaf.sim.v1.WriteDevicesResponse;

/** What a component commands within one tick, at a server that notes its exchanges. */
class PendingCommandsTest {
  @TempDir Path folder;
  private final List<String> exchanges = Collections.synchronizedList(new ArrayList<>());
  private volatile Status stepRejection = Status.OK;
  private volatile double effort;
  private Server server;
  private Simulation simulation;

  private final class Control extends SimulationControlGrpc.SimulationControlImplBase {
    @Override
    public void createSession(
        CreateSessionRequest request, StreamObserver<CreateSessionResponse> out) {
      CommandNumber limited =
          CommandNumber.newBuilder().setName("effort").setMin(-3).setMax(3).build();
      WorldDescription.Builder world = WorldDescription.newBuilder().setTimestepNs(2_000_000);
      world.addDevicesBuilder().setName("a").setKind("joint_motor").addCommands(limited);
      world.addDevicesBuilder().setName("b").setKind("joint_motor").addCommands(limited);
      world.addDevices(DeviceDescription.newBuilder().setName("old").setKind("joint_motor"));
      world
          .addDevicesBuilder()
          .setName("base")
          .setKind("differential_drive")
          .addCommands(unlimited("linear"))
          .addCommands(unlimited("angular"))
          .addBounds(wheel(-2))
          .addBounds(wheel(2));
      answer(
          out,
          CreateSessionResponse.newBuilder()
              .setSessionId("s1")
              .setWorld(world)
              .setState(state())
              .build());
    }

    @Override
    public void prepare(PrepareRequest request, StreamObserver<PrepareResponse> out) {
      effort = 0;
      answer(out, PrepareResponse.newBuilder().setState(state()).build());
    }

    @Override
    public void stepSimulation(
        StepSimulationRequest request, StreamObserver<StepSimulationResponse> out) {
      note("step " + request.getSteps(), request.getCommandsList());
      if (stepRejection.isOk()) {
        answer(out, StepSimulationResponse.newBuilder().setState(state()).build());
      } else {
        out.onError(stepRejection.asRuntimeException());
      }
    }
  }

  private static CommandNumber unlimited(String number) {
    return CommandNumber.newBuilder()
        .setName(number)
        .setMin(Double.NEGATIVE_INFINITY)
        .setMax(Double.POSITIVE_INFINITY)
        .build();
  }

  private static CommandBound wheel(double turning) {
    return CommandBound.newBuilder()
        .putFactors("linear", 10)
        .putFactors("angular", turning)
        .setMin(-10)
        .setMax(10)
        .build();
  }

  private final class Devices extends VirtualHardwareGrpc.VirtualHardwareImplBase {
    @Override
    public void writeDevices(
        WriteDevicesRequest request, StreamObserver<WriteDevicesResponse> out) {
      double wanted = request.getCommands(0).getJoint().getEffort();
      if (wanted > 3) {
        out.onError(
            Status.OUT_OF_RANGE.withDescription("commands: a.effort: " + wanted).asException());
        return;
      }
      note("write", request.getCommandsList());
      answer(out, WriteDevicesResponse.newBuilder().setState(state()).build());
    }
  }

  @BeforeEach
  void openSession() throws IOException {
    server =
        Grpc.newServerBuilderForPort(0, InsecureServerCredentials.create())
            .addService(new Control())
            .addService(new Devices())
            .build()
            .start();
    Path world = Files.writeString(folder.resolve("w.world.yaml"), "mjcf: w.xml\n");
    simulation =
        Simulation.open(
            "127.0.0.1:" + server.getPort(), world, 1, new Stopwatch(), count -> List.of());
    simulation.prepare(Map.of(), Duration.ZERO);
  }

  @AfterEach
  void close() throws InterruptedException {
    simulation.close();
    server.shutdownNow().awaitTermination(5, TimeUnit.SECONDS);
  }

  @Test
  void theCommandsOfATickTravelWithItsStepInTheOrderGiven() {
    JointMotor a = simulation.hardware().jointMotor("a");
    JointMotor b = simulation.hardware().jointMotor("b");
    simulation.every(
        Duration.ofMillis(4),
        () -> {
          b.effort(1 + a.position());
          a.effort(2);
          b.effort(-1);
        });
    simulation.advance(Duration.ofMillis(12));
    assertThat(exchanges)
        .containsExactly("step 2", "step 2 b=1.0 a=2.0 b=-1.0", "step 2 b=1.0 a=2.0 b=-1.0");
  }

  @Test
  void aNumberThatACommandChangesIsReadAfterTheCommand() {
    JointMotor a = simulation.hardware().jointMotor("a");
    a.effort(2);
    assertThat(a.velocity()).isZero();
    assertThat(exchanges).isEmpty();
    assertThat(a.effort()).isEqualTo(2);
    assertThat(exchanges).containsExactly("write a=2.0");
    simulation.advance(Duration.ofMillis(2));
    assertThat(exchanges).containsExactly("write a=2.0", "step 1");
  }

  @Test
  void aCommandThatMayBeRejectedIsSentAtTheCallAfterTheEarlierOnes() {
    JointMotor a = simulation.hardware().jointMotor("a");
    simulation.hardware().jointMotor("b").effort(1);
    assertThatThrownBy(() -> a.effort(3.5))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("commands: a.effort: 3.5");
    a.effort(Double.NaN);
    simulation.hardware().jointMotor("old").effort(1);
    assertThat(exchanges).containsExactly("write b=1.0", "write a=NaN", "write old=1.0");
  }

  @Test
  void aCommandThatIsRejectedAtTheTickIsAnErrorOfTheComponent() {
    simulation.hardware().jointMotor("a").effort(1);
    stepRejection = Status.OUT_OF_RANGE.withDescription("commands: a.effort: 1");
    assertThatThrownBy(() -> simulation.advance(Duration.ofMillis(2)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("commands: a.effort: 1");
    assertThatThrownBy(() -> simulation.advance(Duration.ofMillis(2)))
        .isInstanceOf(SimulationException.class);
  }

  @Test
  void aNewCaseForgetsCommandsThatNoStepTook() {
    simulation.hardware().jointMotor("a").effort(1);
    simulation.prepare(Map.of(), Duration.ZERO);
    simulation.advance(Duration.ofMillis(2));
    assertThat(exchanges).containsExactly("step 1");
  }

  @Test
  void aDriveWaitsForTheTickWhereBothWheelsReachTheirSpeed() {
    DifferentialDrive base = simulation.hardware().differentialDrive("base");
    base.drive(0.9, 0.25);
    assertThat(exchanges).isEmpty();
    base.drive(0.9, -0.75);
    base.drive(0.9, 0.75);
    base.drive(0.9, Double.NaN);
    assertThat(exchanges).hasSize(4).startsWith("write base=0.0").doesNotContain("step");
  }

  private void note(String what, List<DeviceCommand> commands) {
    StringBuilder text = new StringBuilder(what);
    for (DeviceCommand command : commands) {
      effort = command.getJoint().getEffort();
      text.append(' ').append(command.getDevice()).append('=').append(effort);
    }
    exchanges.add(text.toString());
  }

  private WorldState state() {
    WorldState.Builder state = WorldState.newBuilder();
    for (String motor : List.of("a", "b", "old")) {
      state.addReadings(
          Reading.newBuilder()
              .setDevice(motor)
              .setJoint(JointState.newBuilder().setEffort(effort)));
    }
    return state.build();
  }

  private static <T> void answer(StreamObserver<T> out, T message) {
    out.onNext(message);
    out.onCompleted();
  }
}
