package org.sitaf.agent.manager;

import io.grpc.ClientInterceptors;
import io.grpc.ManagedChannel;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import io.grpc.stub.ClientCallStreamObserver;
import io.grpc.stub.ClientResponseObserver;
import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AgentMessage;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.Heartbeat;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.Registered;
import org.sitaf.agent.v1.ServerMessage;

/**
 * The agent's bidirectional stream: registers, sends heartbeats, and reconnects when the stream
 * ends. Uses its own thread, so that builds cannot delay heartbeats.
 */
final class ServerConnection implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration REGISTRATION = Duration.ofSeconds(15);
  private static final Duration SHORTEST_INTERVAL = Duration.ofMillis(20);
  private static final int HEARTBEATS_PER_LEASE = 3;

  /**
   * After a restart, a server grants every agent a full lease; an agent tries to connect several
   * times within it.
   */
  private static final int CONNECTS_PER_LEASE = 3;

  private static final Duration DEFAULT_LEASE = Duration.ofSeconds(15);

  private final ManagedChannel channel;
  private final AgentKey key;
  private final Supplier<Register> registration;
  private final Supplier<List<AttemptRef>> running;
  private final Supplier<String> refusal;
  private final Listener listener;
  private final CountDownLatch closing = new CountDownLatch(1);
  private final AtomicBoolean heartbeatRequested = new AtomicBoolean();
  private final Thread thread = new Thread(this::work, "sitaf-heartbeat");

  /** Receives the server's messages, in gRPC's threads. */
  interface Listener {
    /** The server has registered the agent. */
    void registered(Registered registered);

    /** The agent has had no connection to a server for the duration of a lease. */
    void leaseLost();

    /** An assignment or a cancellation. */
    void message(ServerMessage message);
  }

  ServerConnection(
      ManagedChannel channel,
      AgentKey key,
      Supplier<Register> registration,
      Supplier<List<AttemptRef>> running,
      Supplier<String> refusal,
      Listener listener) {
    this.channel = channel;
    this.key = key;
    this.registration = registration;
    this.running = running;
    this.refusal = refusal;
    this.listener = listener;
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  private void work() {
    Backoff backoff = new Backoff();
    backoff.atMost(DEFAULT_LEASE.dividedBy(CONNECTS_PER_LEASE));
    String lastComplaint = "";
    long leaseEnd = Long.MAX_VALUE;
    try {
      while (closing.getCount() > 0) {
        // Use our own backoff; the channel's would grow to minutes.
        channel.resetConnectBackoff();
        Stream stream = new Stream();
        Status status = enrolled();
        if (status.isOk()) {
          status = stream.live();
        }
        if (status.getCode() == Status.Code.UNAUTHENTICATED) {
          key.refused();
        }
        Duration lease = stream.lease;
        if (lease != null) {
          leaseEnd = System.nanoTime() + lease.toNanos();
          backoff.atMost(lease.dividedBy(CONNECTS_PER_LEASE));
          backoff.reset();
          lastComplaint = "";
        }
        if (leaseEnd != Long.MAX_VALUE && System.nanoTime() - leaseEnd > 0) {
          leaseEnd = Long.MAX_VALUE;
          listener.leaseLost();
        }
        if (closing.getCount() > 0) {
          String problem = "no connection to the server: " + ServerCalls.describe(status);
          if (!problem.equals(lastComplaint)) {
            LOGGER.log(System.Logger.Level.WARNING, problem);
            lastComplaint = problem;
          }
          if (closing.await(backoff.next().toMillis(), TimeUnit.MILLISECONDS)) {
            return;
          }
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Ensures that the agent has a key. */
  private Status enrolled() {
    try {
      key.enrol(channel);
      return Status.OK;
    } catch (StatusRuntimeException e) {
      return e.getStatus();
    } catch (IOException e) {
      return Status.INTERNAL.withDescription("the key cannot be stored").withCause(e);
    }
  }

  @Override
  public void close() {
    closing.countDown();
    try {
      thread.join(Duration.ofSeconds(2).toMillis());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Sends the next heartbeat at once, because its content has changed. */
  void requestHeartbeat() {
    heartbeatRequested.set(true);
  }

  /** One stream, from connect to end. */
  private final class Stream implements ClientResponseObserver<AgentMessage, ServerMessage> {
    private final CountDownLatch ended = new CountDownLatch(1);
    private volatile Status status = Status.OK;
    private volatile @Nullable Duration lease;
    private volatile @Nullable Duration interval;
    private volatile @Nullable ClientCallStreamObserver<AgentMessage> requests;

    boolean registered() {
      return interval != null;
    }

    Status live() throws InterruptedException {
      var sender =
          AgentServiceGrpc.newStub(ClientInterceptors.intercept(channel, key)).connect(this);
      try {
        sender.onNext(AgentMessage.newBuilder().setRegister(registration.get()).build());
        long registrationEnd = System.nanoTime() + REGISTRATION.toNanos();
        while (!awaitEnd(interval)) {
          if (closing.getCount() == 0) {
            sender.onCompleted();
            ended.await(1, TimeUnit.SECONDS);
            break;
          }
          if (registered()) {
            Heartbeat heartbeat =
                Heartbeat.newBuilder()
                    .addAllRunning(running.get())
                    .setRefuses(refusal.get())
                    .build();
            sender.onNext(AgentMessage.newBuilder().setHeartbeat(heartbeat).build());
          } else if (System.nanoTime() - registrationEnd > 0) {
            status =
                Status.DEADLINE_EXCEEDED.withDescription(
                    "the server does not answer the registration");
            break;
          }
        }
      } catch (IllegalStateException | StatusRuntimeException e) {
        // The stream ended while a message was sent.
        LOGGER.log(System.Logger.Level.DEBUG, "stream ended while sending", e);
      } finally {
        ClientCallStreamObserver<AgentMessage> call = requests;
        if (call != null) {
          call.cancel("the stream has ended", null);
        }
      }
      return status;
    }

    /** Waits for the end of the stream or the next heartbeat; returns soon after close. */
    private boolean awaitEnd(@Nullable Duration heartbeatInterval) throws InterruptedException {
      Duration step = Duration.ofMillis(50);
      long due =
          System.nanoTime() + (heartbeatInterval == null ? step : heartbeatInterval).toNanos();
      while (closing.getCount() > 0) {
        long left = due - System.nanoTime();
        if (left <= 0 || (registered() && heartbeatRequested.getAndSet(false))) {
          return ended.getCount() == 0;
        }
        if (ended.await(Math.min(left, step.toNanos()), TimeUnit.NANOSECONDS)) {
          return true;
        }
      }
      return ended.getCount() == 0;
    }

    @Override
    public void beforeStart(ClientCallStreamObserver<AgentMessage> requestStream) {
      requests = requestStream;
    }

    @Override
    public void onNext(ServerMessage message) {
      if (message.hasRegistered()) {
        var given = message.getRegistered().getLease();
        Duration granted = Duration.ofSeconds(given.getSeconds(), given.getNanos());
        lease = granted;
        Duration wanted = granted.dividedBy(HEARTBEATS_PER_LEASE + 1);
        interval = wanted.compareTo(SHORTEST_INTERVAL) < 0 ? SHORTEST_INTERVAL : wanted;
        listener.registered(message.getRegistered());
      } else {
        listener.message(message);
      }
    }

    @Override
    public void onError(Throwable failure) {
      status = Status.fromThrowable(failure);
      ended.countDown();
    }

    @Override
    public void onCompleted() {
      status = Status.UNAVAILABLE.withDescription("the server ended the stream");
      ended.countDown();
    }
  }
}
