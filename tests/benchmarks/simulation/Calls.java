import io.grpc.Grpc;
import io.grpc.InsecureChannelCredentials;
import io.grpc.ManagedChannel;
import io.grpc.stub.StreamObserver;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.SynchronousQueue;
import org.sitaf.runtime.RangeSensor;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.Simulation;
import org.sitaf.sim.v1.OperateRequest;
import org.sitaf.sim.v1.OperateResponse;
import org.sitaf.sim.v1.PingRequest;
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.RenewSessionRequest;
import org.sitaf.sim.v1.SimulationControlGrpc;
import org.sitaf.sim.v1.SimulationControlGrpc.SimulationControlBlockingStub;
import org.sitaf.sim.v1.StepSimulationRequest;

/**
 * Measures calls from Java. Prints `name value` lines: microseconds per call (medians over rounds that
 * alternate between the kinds), cases per second, nanoseconds per reading. Arguments: target, session
 * of the infrared world, description of the world.
 */
public final class Calls {
  private static final int ROUNDS = 30;
  private static final int CALLS = 100;
  private static final int CASES = 100_000;
  private static final int READS = 2_000_000;

  private interface Call {
    void make(int index) throws Exception;
  }

  public static void main(String[] arguments) throws Exception {
    String target = arguments[0];
    String session = arguments[1];
    ManagedChannel channel =
        Grpc.newChannelBuilder(target, InsecureChannelCredentials.create())
            .maxInboundMessageSize(64 << 20)
            .directExecutor()
            .build();
    SimulationControlBlockingStub stub = SimulationControlGrpc.newBlockingStub(channel);
    SynchronousQueue<OperateResponse> answers = new SynchronousQueue<>();
    StreamObserver<OperateRequest> stream =
        SimulationControlGrpc.newStub(channel)
            .operate(
                new StreamObserver<>() {
                  @Override
                  public void onNext(OperateResponse response) {
                    try {
                      answers.put(response);
                    } catch (InterruptedException e) {
                      Thread.currentThread().interrupt();
                    }
                  }

                  @Override
                  public void onError(Throwable thrown) {}

                  @Override
                  public void onCompleted() {}
                });
    OperateRequest ping =
        OperateRequest.newBuilder().setPing(PingRequest.getDefaultInstance()).build();
    RenewSessionRequest renew = RenewSessionRequest.newBuilder().setSessionId(session).build();
    String[] names = {"unary_empty", "unary_step", "stream_empty", "stream_step"};
    Call[] calls = {
      i -> stub.renewSession(renew),
      i -> stub.stepSimulation(step(session, i)),
      i -> {
        stream.onNext(ping);
        answers.take();
      },
      i -> {
        stream.onNext(OperateRequest.newBuilder().setStep(step(session, i)).build());
        OperateResponse answer = answers.take();
        if (!answer.hasState()) {
          throw new IllegalStateException(answer.getRefusal().getMessage());
        }
      }
    };
    double[][] times = new double[calls.length][ROUNDS];
    for (int round = -5; round < ROUNDS; round++) {
      for (int kind = 0; kind < calls.length; kind++) {
        long began = System.nanoTime();
        for (int i = 0; i < CALLS; i++) {
          calls[kind].make(i);
        }
        if (round >= 0) {
          times[kind][round] = (System.nanoTime() - began) / 1e3 / CALLS;
        }
      }
    }
    stream.onCompleted();
    for (int kind = 0; kind < calls.length; kind++) {
      Arrays.sort(times[kind]);
      System.out.println(names[kind] + " " + times[kind][ROUNDS / 2]);
    }
    System.out.println("bulk " + bulk(stub, session));
    channel.shutdownNow();
    System.out.println("read " + read(target, Path.of(arguments[2])));
  }

  private static StepSimulationRequest step(String session, int index) {
    return StepSimulationRequest.newBuilder()
        .setSessionId(session)
        .setSteps(1)
        .putParameters("Distance", index / 10.0)
        .build();
  }

  /** Cases per second; the best of three, because other load only slows it down. */
  private static double bulk(SimulationControlBlockingStub stub, String session) {
    PrepareManyRequest.Builder request =
        PrepareManyRequest.newBuilder().setSessionId(session).addParameters("Distance");
    for (int i = 0; i < CASES; i++) {
      request.addValues(i * 20.0 / CASES);
    }
    request.setCases(CASES);
    double best = 0;
    for (int round = 0; round < 4; round++) {
      long began = System.nanoTime();
      int count = stub.prepareMany(request.build()).getReadingsCount();
      if (count != CASES * 8) {
        throw new IllegalStateException(count + " readings");
      }
      best = Math.max(best, CASES / ((System.nanoTime() - began) / 1e9));
    }
    return best;
  }

  /** Nanoseconds per reading between two steps. */
  private static double read(String target, Path world) throws Exception {
    try (Simulation simulation = Simulation.open(target, world, 1, new Stopwatch(), count -> List.of())) {
      simulation.prepare(Map.of("Distance", 0.3), Duration.ZERO);
      RangeSensor sensor = simulation.hardware().rangeSensor("ir1");
      double sum = 0;
      long began = 0;
      for (int i = -READS; i < READS; i++) {
        if (i == 0) {
          began = System.nanoTime();
          sum = 0;
        }
        sum += sensor.range();
      }
      double nanos = (System.nanoTime() - began) / (double) READS;
      if (Math.abs(sum / READS - 0.3) > 1e-9 || sensor.range() != 0.3) {
        throw new IllegalStateException("read " + sum / READS);
      }
      return nanos;
    }
  }
}
