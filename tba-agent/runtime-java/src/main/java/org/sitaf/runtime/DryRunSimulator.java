package org.sitaf.runtime;

import com.google.protobuf.Duration;
import io.grpc.Grpc;
import io.grpc.InsecureServerCredentials;
import io.grpc.Server;
import io.grpc.stub.StreamObserver;
import java.io.IOException;
import java.util.stream.Stream;
import org.sitaf.sim.v1.CreateSessionRequest;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeleteSessionRequest;
import org.sitaf.sim.v1.DeleteSessionResponse;
import org.sitaf.sim.v1.DeviceDescription;
import org.sitaf.sim.v1.Observation;
import org.sitaf.sim.v1.ObservationDescription;
import org.sitaf.sim.v1.ParameterDescription;
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.PrepareManyResponse;
import org.sitaf.sim.v1.PrepareRequest;
import org.sitaf.sim.v1.PrepareResponse;
import org.sitaf.sim.v1.Range;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.WorldDescription;
import org.sitaf.sim.v1.WorldState;

/** A minimal simulator for {@link DryRun}: one sensor, which reads the value that was set. */
final class DryRunSimulator extends SimulationControlGrpc.SimulationControlImplBase {
  /** The one device, of the kind {@code range}. */
  static final String SENSOR = "r";

  private static final String OBSERVATION = "o";

  /** Starts the server on a free port of the loopback interface. */
  static Server listening() throws IOException {
    return Grpc.newServerBuilderForPort(0, InsecureServerCredentials.create())
        .addService(new DryRunSimulator())
        .build()
        .start();
  }

  @Override
  public void createSession(
      CreateSessionRequest request, StreamObserver<CreateSessionResponse> out) {
    DeviceDescription sensor =
        DeviceDescription.newBuilder()
            .setName(SENSOR)
            .setKind("range")
            .addFields("range_m")
            .build();
    answer(
        out,
        CreateSessionResponse.newBuilder()
            .setSessionId("dry-run")
            .setWorld(
                WorldDescription.newBuilder()
                    .setDigest("0")
                    .setTimestepNs(1_000_000)
                    .addParameters(ParameterDescription.newBuilder().setName("x").setUnit("m"))
                    .addDevices(sensor)
                    .addObservations(ObservationDescription.newBuilder().setName(OBSERVATION))
                    .addEntities("e"))
            .setLease(Duration.newBuilder().setSeconds(60))
            .setState(reading(0))
            .build());
  }

  @Override
  public void prepare(PrepareRequest request, StreamObserver<PrepareResponse> out) {
    double set = request.getParametersMap().values().iterator().next();
    answer(out, PrepareResponse.newBuilder().setState(reading(set)).build());
  }

  @Override
  public void prepareMany(PrepareManyRequest request, StreamObserver<PrepareManyResponse> out) {
    answer(
        out,
        PrepareManyResponse.newBuilder()
            .addColumns(SENSOR + ".range_m")
            .addColumns(OBSERVATION)
            .addAllReadings(
                request.getValuesList().stream().flatMap(x -> Stream.of(x, 0.0)).toList())
            .build());
  }

  @Override
  public void deleteSession(
      DeleteSessionRequest request, StreamObserver<DeleteSessionResponse> out) {
    answer(out, DeleteSessionResponse.getDefaultInstance());
  }

  private static WorldState reading(double metres) {
    Range range = Range.newBuilder().setRangeM(metres).setMaxRangeM(10).build();
    return WorldState.newBuilder()
        .addReadings(Reading.newBuilder().setDevice(SENSOR).setRange(range))
        .addObservations(Observation.newBuilder().setName(OBSERVATION))
        .build();
  }

  private static <T> void answer(StreamObserver<T> out, T message) {
    out.onNext(message);
    out.onCompleted();
  }
}
