package org.sitaf.server.build.agent;

import io.grpc.ForwardingServerCall.SimpleForwardingServerCall;
import io.grpc.ForwardingServerCallListener.SimpleForwardingServerCallListener;
import io.grpc.Metadata;
import io.grpc.ServerCall;
import io.grpc.Status;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.sitaf.server.timer.DaemonTimer;
import org.springframework.beans.factory.DisposableBean;
import org.springframework.stereotype.Component;

/**
 * Calls of those who have shown no key. Each may bring a message into memory: there are a few at
 * the same time, and none for long.
 */
@Component
class Strangers implements DisposableBean {
  private static final int AT_ONCE = 16;
  private static final int OF_ONE = 8;
  private static final long PATIENCE_S = 10;

  private final ScheduledExecutorService timer = DaemonTimer.named("enrolments");
  private final Map<String, Integer> present = new HashMap<>();
  private int all;

  /** Has a call go on, or ends it at once when there are too many. */
  <Q, A> ServerCall.Listener<Q> admit(
      String address,
      ServerCall<Q, A> call,
      Function<ServerCall<Q, A>, ServerCall.Listener<Q>> next) {
    if (!enter(address)) {
      call.close(
          Status.RESOURCE_EXHAUSTED.withDescription(
              "too many agents enrol at this moment; try again soon"),
          new Metadata());
      return new ServerCall.Listener<>() {};
    }
    Bounded<Q, A> bounded = new Bounded<>(call);
    ScheduledFuture<?> end = timer.schedule(bounded::giveUp, PATIENCE_S, TimeUnit.SECONDS);
    ServerCall.Listener<Q> listener;
    try {
      listener = next.apply(bounded);
    } catch (RuntimeException e) {
      leave(address, end);
      throw e;
    }
    return new SimpleForwardingServerCallListener<>(listener) {
      @Override
      public void onComplete() {
        leave(address, end);
        super.onComplete();
      }

      @Override
      public void onCancel() {
        leave(address, end);
        super.onCancel();
      }
    };
  }

  private synchronized boolean enter(String address) {
    int own = present.getOrDefault(address, 0);
    if (all >= AT_ONCE || own >= OF_ONE) {
      return false;
    }
    present.put(address, own + 1);
    all++;
    return true;
  }

  private synchronized void leave(String address, ScheduledFuture<?> end) {
    end.cancel(false);
    present.computeIfPresent(address, (key, own) -> own == 1 ? null : own - 1);
    all--;
  }

  @Override
  public void destroy() {
    timer.shutdownNow();
  }

  /** Closed by its service, or when its time is over; the other comes too late. */
  private static final class Bounded<Q, A> extends SimpleForwardingServerCall<Q, A> {
    private boolean closed;

    Bounded(ServerCall<Q, A> call) {
      super(call);
    }

    synchronized void giveUp() {
      close(
          Status.DEADLINE_EXCEEDED.withDescription("the enrolment did not arrive in time"),
          new Metadata());
    }

    @Override
    public synchronized void sendHeaders(Metadata headers) {
      if (!closed) {
        super.sendHeaders(headers);
      }
    }

    @Override
    public synchronized void sendMessage(A message) {
      if (!closed) {
        super.sendMessage(message);
      }
    }

    @Override
    public synchronized void close(Status status, Metadata trailers) {
      if (!closed) {
        closed = true;
        super.close(status, trailers);
      }
    }
  }
}
