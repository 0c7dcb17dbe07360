package org.sitaf.runtime.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.protobuf.ByteString;
import com.google.protobuf.Duration;
import io.grpc.Grpc;
import io.grpc.InsecureServerCredentials;
import io.grpc.Server;
import io.grpc.ServerBuilder;
import io.grpc.Status;
import io.grpc.netty.shaded.io.grpc.netty.NettyServerBuilder;
import io.grpc.netty.shaded.io.netty.channel.epoll.EpollEventLoopGroup;
import io.grpc.netty.shaded.io.netty.channel.epoll.EpollServerDomainSocketChannel;
import io.grpc.netty.shaded.io.netty.channel.unix.DomainSocketAddress;
import io.grpc.stub.StreamObserver;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.RangeSensor;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.sim.v1.CreateSessionRequest;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeleteSessionRequest;
import org.sitaf.sim.v1.DeleteSessionResponse;
import org.sitaf.sim.v1.DeviceDescription;
import org.sitaf.sim.v1.Observation;
import org.sitaf.sim.v1.PrepareRequest;
import org.sitaf.sim.v1.PrepareResponse;
import org.sitaf.sim.v1.Range;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.RecordMotionRequest;
import org.sitaf.sim.v1.RecordMotionResponse;
import org.sitaf.sim.v1.RenewSessionRequest;
import org.sitaf.sim.v1.RenewSessionResponse;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.StepSimulationRequest;
import org.sitaf.sim.v1.StepSimulationResponse;
import org.sitaf.sim.v1.TakeMotionRequest;
import org.sitaf.sim.v1.TakeMotionResponse;
import org.sitaf.sim.v1.WorldDescription;
import org.sitaf.sim.v1.WorldState;

/** The client of the simulator with a minimal server; the examples run it with the simulator. */
class SimulationTest {
  @TempDir Path folder;
  private final OneSession service = new OneSession();
  private final Stopwatch stopwatch = new Stopwatch();
  private Server server;
  private Path world;

  /** One session. Its only sensor reads the value that was set; x counts steps. */
  private static final class OneSession extends SimulationControlGrpc.SimulationControlImplBase {
    final List<String> calls = Collections.synchronizedList(new ArrayList<>());
    volatile CreateSessionRequest created = CreateSessionRequest.getDefaultInstance();
    volatile Status rejection = Status.OK;
    volatile int motion = 3;
    private double distance = 5;
    private long steps;

    @Override
    public void createSession(
        CreateSessionRequest request, StreamObserver<CreateSessionResponse> out) {
      created = request;
      answer(
          out,
          CreateSessionResponse.newBuilder()
              .setSessionId("s1")
              .setWorld(
                  WorldDescription.newBuilder()
                      .setTimestepNs(2_000_000)
                      .addDevices(DeviceDescription.newBuilder().setName("ir1").setKind("range"))
                      .addDevices(DeviceDescription.newBuilder().setName("cam").setKind("camera")))
              .setLease(Duration.newBuilder().setNanos(300_000_000))
              .setState(state())
              .build());
    }

    @Override
    public void prepare(PrepareRequest request, StreamObserver<PrepareResponse> out) {
      calls.add("prepare " + request.getParametersMap() + " " + request.getSettleNs());
      distance = request.getParametersOrDefault("Distance", 5);
      steps = 0;
      answer(out, PrepareResponse.newBuilder().setState(state()).build());
    }

    @Override
    public void stepSimulation(
        StepSimulationRequest request, StreamObserver<StepSimulationResponse> out) {
      steps += request.getSteps();
      answer(out, StepSimulationResponse.newBuilder().setState(state()).build());
    }

    @Override
    public void recordMotion(
        RecordMotionRequest request, StreamObserver<RecordMotionResponse> out) {
      calls.add("record every " + request.getIntervalNs());
      answer(out, RecordMotionResponse.getDefaultInstance());
    }

    @Override
    public void takeMotion(TakeMotionRequest request, StreamObserver<TakeMotionResponse> out) {
      calls.add("take");
      answer(
          out,
          TakeMotionResponse.newBuilder().setGltf(ByteString.copyFrom(new byte[motion])).build());
    }

    @Override
    public void renewSession(
        RenewSessionRequest request, StreamObserver<RenewSessionResponse> out) {
      calls.add("renew");
      answer(out, RenewSessionResponse.getDefaultInstance());
    }

    @Override
    public void deleteSession(
        DeleteSessionRequest request, StreamObserver<DeleteSessionResponse> out) {
      calls.add("delete " + request.getSessionId());
      answer(out, DeleteSessionResponse.getDefaultInstance());
    }

    private WorldState state() {
      Range range = Range.newBuilder().setRangeM(distance).setMaxRangeM(10).build();
      return WorldState.newBuilder()
          .addReadings(Reading.newBuilder().setDevice("ir1").setRange(range))
          .addObservations(Observation.newBuilder().setName("x").setValue(steps))
          .build();
    }

    private <T> void answer(StreamObserver<T> out, T message) {
      if (rejection.isOk()) {
        out.onNext(message);
        out.onCompleted();
      } else {
        out.onError(rejection.asRuntimeException());
      }
    }
  }

  @BeforeEach
  void startServer() throws IOException {
    server = start(Grpc.newServerBuilderForPort(0, InsecureServerCredentials.create()));
    Files.createDirectory(folder.resolve("world"));
    world = Files.writeString(folder.resolve("world/w.world.yaml"), "mjcf: w.xml\n");
    Files.writeString(folder.resolve("world/w.xml"), "<mujoco/>");
    Files.createDirectory(folder.resolve("world/mesh"));
    Files.writeString(folder.resolve("world/mesh/a.obj"), "v");
    Path outside = Files.writeString(folder.resolve("outside"), "not the world's");
    Files.createSymbolicLink(folder.resolve("world/link"), outside);
  }

  @AfterEach
  void stopServer() throws InterruptedException {
    server.shutdownNow().awaitTermination(5, TimeUnit.SECONDS);
  }

  private Server start(ServerBuilder<?> builder) throws IOException {
    return builder.addService(service).build().start();
  }

  private Simulation open() throws IOException {
    return Simulation.open(
        "127.0.0.1:" + server.getPort(), world, 7, stopwatch, count -> List.of());
  }

  @Test
  void sendsOnlyFilesOfTheWorldFolder() throws IOException {
    open().close();
    assertThat(service.created.getSeed()).isEqualTo(7);
    assertThat(service.created.getWorld().getDescription()).isEqualTo("w.world.yaml");
    assertThat(service.created.getWorld().getFilesMap().keySet())
        .containsExactlyInAnyOrder("w.world.yaml", "w.xml", "mesh/a.obj");
    assertThat(service.calls).contains("delete s1");
  }

  @Test
  void readsTheLastStepWithoutARoundTrip() throws IOException {
    try (Simulation simulation = open()) {
      RangeSensor sensor = simulation.hardware().rangeSensor("ir1");
      simulation.prepare(Map.of("Distance", 9.5), java.time.Duration.ofMillis(10));
      int calls = service.calls.size();
      assertThat(sensor.range()).isEqualTo(9.5);
      assertThat(sensor.maxRange()).isEqualTo(10);
      simulation.prepare(Map.of("Distance", Double.NEGATIVE_INFINITY), java.time.Duration.ZERO);
      assertThat(sensor.range()).isEqualTo(Double.NEGATIVE_INFINITY);
      assertThat(service.calls.get(calls - 1)).isEqualTo("prepare {Distance=9.5} 10000000");
      assertThat(service.calls.stream().filter(c -> c.startsWith("prepare"))).hasSize(2);
    }
  }

  @Test
  void roundsTimeUpToWholeSteps() throws IOException {
    try (Simulation simulation = open()) {
      simulation.prepare(Map.of(), java.time.Duration.ZERO);
      simulation.advance(java.time.Duration.ZERO);
      assertThat(simulation.observation("x")).isZero();
      simulation.advance(java.time.Duration.ofMillis(3));
      assertThat(simulation.observation("x")).isEqualTo(2);
      assertThatThrownBy(() -> simulation.observation("y")).hasMessageContaining("it has [x]");
    }
  }

  @Test
  void distinguishesARejectedRequestFromALostSimulator() throws IOException {
    try (Simulation simulation = open()) {
      service.rejection = Status.OUT_OF_RANGE.withDescription("Distance: 25 m is beyond 20 m");
      assertThatThrownBy(
              () -> simulation.prepare(Map.of("Distance", 25.0), java.time.Duration.ZERO))
          .isInstanceOfSatisfying(SimulationException.class, e -> assertThat(e.isLost()).isFalse())
          .hasMessage(
              "simulator: setting {Distance=25.0}: OUT_OF_RANGE: Distance: 25 m is beyond 20 m");
      service.rejection = Status.NOT_FOUND.withDescription("no session s1");
      assertThatThrownBy(() -> simulation.advance(java.time.Duration.ofSeconds(1)))
          .isInstanceOfSatisfying(SimulationException.class, e -> assertThat(e.isLost()).isTrue());
    }
  }

  @Test
  void connectsThroughAUnixSocket() throws IOException, InterruptedException {
    Path socket = folder.resolve("bridge.sock");
    EpollEventLoopGroup loop = new EpollEventLoopGroup(1);
    Server local =
        start(
            NettyServerBuilder.forAddress(
                    new DomainSocketAddress(socket.toFile()), InsecureServerCredentials.create())
                .channelType(EpollServerDomainSocketChannel.class)
                .bossEventLoopGroup(loop)
                .workerEventLoopGroup(loop));
    try (Simulation simulation =
        Simulation.open("unix:" + socket, world, 1, stopwatch, count -> List.of())) {
      assertThat(simulation.hardware().rangeSensor("ir1").range()).isEqualTo(5);
    } finally {
      local.shutdownNow().awaitTermination(5, TimeUnit.SECONDS);
      loop.shutdownGracefully(0, 1, TimeUnit.SECONDS).await(5, TimeUnit.SECONDS);
    }
  }

  /** The JVM would wait 0.3 s for a thread in native code before it exits. */
  @Test
  void leavesNoThreadThatDelaysTheExit() throws IOException, InterruptedException {
    try (Simulation simulation = open()) {
      simulation.prepare(Map.of("Distance", 2.0), java.time.Duration.ZERO);
      assertThat(threads()).anyMatch(name -> name.startsWith(SimulatorChannel.THREAD));
    }
    // The thread still has to return.
    for (int i = 0; i < 30 && threads().toString().contains(SimulatorChannel.THREAD); i++) {
      Thread.sleep(10);
    }
    assertThat(threads()).noneMatch(name -> name.startsWith(SimulatorChannel.THREAD));
  }

  private static List<String> threads() {
    return Thread.getAllStackTraces().keySet().stream().map(Thread::getName).toList();
  }

  @Test
  void renewsTheLeaseDuringALongCall() throws IOException, InterruptedException {
    try (Simulation simulation = open()) {
      assertThat(simulation.hardware().devices()).containsExactly("cam", "ir1");
      for (int i = 0; i < 100 && service.calls.stream().filter("renew"::equals).count() < 2; i++) {
        Thread.sleep(50);
      }
    }
    assertThat(service.calls.stream().filter("renew"::equals)).hasSizeGreaterThanOrEqualTo(2);
  }

  @Test
  void measuresTimeInTheHardwareSeparately() throws IOException {
    try (Simulation simulation = open()) {
      RangeSensor sensor = simulation.hardware().rangeSensor("ir1");
      double sum = 0;
      stopwatch.start();
      for (int i = 0; i < 10_000; i++) {
        sum += sensor.range();
      }
      stopwatch.stop();
      assertThat(sum).isEqualTo(50_000);
      assertThat(stopwatch.hardwareMicros()).isPositive();
      assertThat(stopwatch.componentMicros()).isPositive();
      stopwatch.start();
      stopwatch.stop();
      assertThat(stopwatch.hardwareMicros()).isZero();
    }
  }

  @Test
  void reportsAMissingDeviceAndADeviceOfAnotherKind() throws IOException {
    try (Simulation simulation = open()) {
      Hardware hardware = simulation.hardware();
      assertThatThrownBy(() -> hardware.rangeSensor("ir8"))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("the robot has no device 'ir8'; it has [cam, ir1]");
      assertThatThrownBy(() -> hardware.rangeSensor("cam")).hasMessageContaining("of kind camera");
    }
  }

  @Test
  void savesTheMotionOfEachCaseUntilTheFolderIsFull() throws IOException {
    Path recordings = folder.resolve("recordings");
    try (Simulation simulation = open()) {
      simulation.saveMotion(1);
      assertThat(recordings).doesNotExist();
      simulation.record(recordings);
      service.motion = 40 << 20;
      simulation.saveMotion(2);
      simulation.saveMotion(3);
      simulation.saveMotion(4);
    }

    assertThat(recordings.resolve("2.glb")).hasSize(40 << 20);
    assertThat(recordings).isDirectoryNotContaining(file -> !file.endsWith("2.glb"));
    assertThat(service.calls).containsOnlyOnce("record every 20000000");
    assertThat(service.calls.stream().filter("take"::equals)).hasSize(2);
  }

  @Test
  void savesNoMotionWhenTheSimulationDiverged() throws IOException {
    try (Simulation simulation = open()) {
      simulation.record(folder.resolve("recordings"));
      service.rejection = Status.DATA_LOSS.withDescription("it diverged");
      simulation.saveMotion(1);
      assertThat(folder.resolve("recordings")).isEmptyDirectory();
      service.rejection = Status.UNAVAILABLE;
      assertThatThrownBy(() -> simulation.saveMotion(2))
          .isInstanceOf(SimulationException.class)
          .hasMessageContaining("case 2");
      service.rejection = Status.OK;
    }
  }
}
