package org.sitaf.agent.simulation;

import com.google.protobuf.ByteString;
import io.grpc.Grpc;
import io.grpc.InsecureChannelCredentials;
import io.grpc.ManagedChannel;
import io.grpc.ManagedChannelBuilder;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.sitaf.sim.v1.CloseEndpointRequest;
import org.sitaf.sim.v1.DescribeWorldRequest;
import org.sitaf.sim.v1.GetSimulatorFeaturesRequest;
import org.sitaf.sim.v1.GetSimulatorFeaturesResponse;
import org.sitaf.sim.v1.OpenEndpointRequest;
import org.sitaf.sim.v1.OpenEndpointResponse;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.SimulatorAdministrationGrpc;
import org.sitaf.sim.v1.WorldSource;

/** Asks a simulator what it is and whether it accepts a world, before anything is built. */
public final class SimulatorClient implements AutoCloseable {
  private static final int DEADLINE_S = 90;
  private static final int ALIVE_S = 5;

  /**
   * Netty warns of an option that Unix sockets do not have; nobody can do anything about it. Held,
   * or its level is forgotten.
   */
  private static final Logger SOCKET_OPTIONS =
      Logger.getLogger("io.grpc.netty.shaded.io.netty.bootstrap.Bootstrap");

  private final ManagedChannel channel;
  private final String target;

  /** Of the simulator at this gRPC target. */
  public SimulatorClient(String target) {
    this.target = target;
    SOCKET_OPTIONS.setLevel(Level.SEVERE);
    // Through the registry, which finds the transport that a Unix socket needs.
    ManagedChannelBuilder<?> builder =
        Grpc.newChannelBuilder(target, InsecureChannelCredentials.create());
    if (target.startsWith("unix:")) {
      // A socket's path is no host name, and servers refuse it as one.
      builder.overrideAuthority("localhost");
    }
    this.channel = builder.build();
  }

  /**
   * Name and version, such as {@code sitaf-bridge 0.1.0 (MuJoCo 4.0.0)}.
   *
   * @throws SimulatorException when it does not answer
   */
  public String version() throws SimulatorException {
    try {
      GetSimulatorFeaturesResponse features =
          stub().getSimulatorFeatures(GetSimulatorFeaturesRequest.getDefaultInstance());
      return "sitaf-bridge "
          + features.getBridgeVersion()
          + " ("
          + features.getEngine()
          + " "
          + features.getEngineVersion()
          + ")";
    } catch (StatusRuntimeException e) {
      throw notThere(e);
    }
  }

  /**
   * Asks for anything at all.
   *
   * @throws SimulatorException when it does not answer
   */
  void requireAnswer() throws SimulatorException {
    try {
      GetSimulatorFeaturesResponse unused =
          stub()
              .withDeadlineAfter(ALIVE_S, TimeUnit.SECONDS)
              .getSimulatorFeatures(GetSimulatorFeaturesRequest.getDefaultInstance());
    } catch (StatusRuntimeException e) {
      throw notThere(e);
    }
  }

  /**
   * Opens an endpoint of a bridge that serves one build.
   *
   * @param worldDigest of the only world that it offers
   * @throws SimulatorException when it does not
   */
  void openEndpoint(String name, String worldDigest) throws SimulatorException {
    try {
      OpenEndpointResponse unused =
          administration()
              .openEndpoint(
                  OpenEndpointRequest.newBuilder()
                      .setName(name)
                      .setWorldDigest(worldDigest)
                      .build());
    } catch (StatusRuntimeException e) {
      throw notThere(e);
    }
  }

  /** Closes an endpoint; whether all calls in it have ended, as far as the bridge can say. */
  boolean closesEndpoint(String name) {
    try {
      return administration()
          .closeEndpoint(CloseEndpointRequest.newBuilder().setName(name).build())
          .getIdle();
    } catch (StatusRuntimeException e) {
      return false;
    }
  }

  /**
   * Lets the simulator compile a world; its digest.
   *
   * @param description name of the world description among the files
   * @param files of the world's folder, by relative path
   * @throws WorldException when the simulator refuses it
   * @throws SimulatorException when it does not answer
   */
  public String check(String description, Map<String, byte[]> files)
      throws WorldException, SimulatorException {
    WorldSource.Builder world = WorldSource.newBuilder().setDescription(description);
    files.forEach((path, content) -> world.putFiles(path, ByteString.copyFrom(content)));
    try {
      return stub()
          .describeWorld(DescribeWorldRequest.newBuilder().setWorld(world).build())
          .getWorld()
          .getDigest();
    } catch (StatusRuntimeException e) {
      Status.Code code = e.getStatus().getCode();
      if (code == Status.Code.INVALID_ARGUMENT
          || code == Status.Code.OUT_OF_RANGE
          || code == Status.Code.RESOURCE_EXHAUSTED) {
        throw new WorldException(String.valueOf(e.getStatus().getDescription()));
      }
      throw notThere(e);
    }
  }

  private SimulationControlGrpc.SimulationControlBlockingStub stub() {
    return SimulationControlGrpc.newBlockingStub(channel)
        .withDeadlineAfter(DEADLINE_S, TimeUnit.SECONDS);
  }

  private SimulatorAdministrationGrpc.SimulatorAdministrationBlockingStub administration() {
    return SimulatorAdministrationGrpc.newBlockingStub(channel)
        .withDeadlineAfter(ALIVE_S, TimeUnit.SECONDS);
  }

  private SimulatorException notThere(StatusRuntimeException e) {
    return new SimulatorException(
        "the simulator at " + target + " does not answer: " + e.getStatus(), e);
  }

  @Override
  public void close() {
    channel.shutdownNow();
  }
}
