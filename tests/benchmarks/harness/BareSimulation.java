import com.google.protobuf.ByteString;
import io.grpc.Grpc;
import io.grpc.InsecureChannelCredentials;
import io.grpc.ManagedChannel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.sim.v1.CreateSessionRequest;
import org.sitaf.sim.v1.DeleteSessionRequest;
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.SimulationControlGrpc.SimulationControlBlockingStub;
import org.sitaf.sim.v1.WorldSource;

/** The calls that prepare cases in bulk, without a harness around them. */
final class BareSimulation {
  private static final int CALLS = 20;
  private static final int CASES = 1_000;

  private BareSimulation() {}

  static double microsPerCase(String target, Path world) throws Exception {
    ManagedChannel channel =
        Grpc.newChannelBuilder(target, InsecureChannelCredentials.create())
            .maxInboundMessageSize(64 << 20)
            .directExecutor()
            .build();
    try {
      SimulationControlBlockingStub stub = SimulationControlGrpc.newBlockingStub(channel);
      String session =
          stub.createSession(
                  CreateSessionRequest.newBuilder().setWorld(source(world)).setSeed(1).build())
              .getSessionId();
      List<Double> distances = new ArrayList<>();
      for (int i = 0; i < CASES; i++) {
        distances.add(i * 10.0 / CASES);
      }
      PrepareManyRequest request =
          PrepareManyRequest.newBuilder()
              .setSessionId(session)
              .addParameters("Distance")
              .addAllValues(distances)
              .setCases(CASES)
              .build();
      double best = Double.MAX_VALUE;
      for (int round = 0; round < 5; round++) {
        long began = System.nanoTime();
        for (int i = 0; i < CALLS; i++) {
          stub.prepareMany(request);
        }
        best = Math.min(best, (System.nanoTime() - began) / 1e3 / CALLS / CASES);
      }
      stub.deleteSession(DeleteSessionRequest.newBuilder().setSessionId(session).build());
      return best;
    } finally {
      channel.shutdownNow();
    }
  }

  private static WorldSource source(Path description) throws IOException {
    WorldSource.Builder source =
        WorldSource.newBuilder().setDescription(description.getFileName().toString());
    try (Stream<Path> files = Files.list(description.getParent())) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        source.putFiles(file.getFileName().toString(), ByteString.copyFrom(Files.readAllBytes(file)));
      }
    }
    return source.build();
  }
}
