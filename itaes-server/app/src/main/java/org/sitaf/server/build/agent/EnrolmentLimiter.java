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
 * Limits the number and the duration of concurrent enrolments. These calls are not authenticated,
 * and each of them can hold a message in memory.
 */
@Component
class EnrolmentLimiter implements DisposableBean {
  private static final int MAX_CALLS = 16;
  private static final int MAX_CALLS_PER_ADDRESS = 8;
  private static final long TIMEOUT_S = 10;

  private final ScheduledExecutorService timer = DaemonTimer.named("enrolments");
  private final Map<String, Integer> callsByAddress = new HashMap<>();
  private int calls;

  /** Continues a call, or closes it if there are too many. */
  <Q, A> ServerCall.Listener<Q> admit(
      String address,
      ServerCall<Q, A> call,
      Function<ServerCall<Q, A>, ServerCall.Listener<Q>> next) {
    if (!enter(address)) {
      call.close(
          Status.RESOURCE_EXHAUSTED.withDescription(
              "too many concurrent enrolments; try again soon"),
          new Metadata());
      return new ServerCall.Listener<>() {};
    }
    TimedCall<Q, A> timed = new TimedCall<>(call);
    ScheduledFuture<?> timeout = timer.schedule(timed::timeOut, TIMEOUT_S, TimeUnit.SECONDS);
    ServerCall.Listener<Q> listener;
    try {
      listener = next.apply(timed);
    } catch (RuntimeException e) {
      leave(address, timeout);
      throw e;
    }
    return new SimpleForwardingServerCallListener<>(listener) {
      @Override
      public void onComplete() {
        leave(address, timeout);
        super.onComplete();
      }

      @Override
      public void onCancel() {
        leave(address, timeout);
        super.onCancel();
      }
    };
  }

  private synchronized boolean enter(String address) {
    int own = callsByAddress.getOrDefault(address, 0);
    if (calls >= MAX_CALLS || own >= MAX_CALLS_PER_ADDRESS) {
      return false;
    }
    callsByAddress.put(address, own + 1);
    calls++;
    return true;
  }

  private synchronized void leave(String address, ScheduledFuture<?> timeout) {
    timeout.cancel(false);
    callsByAddress.computeIfPresent(address, (key, own) -> own == 1 ? null : own - 1);
    calls--;
  }

  @Override
  public void destroy() {
    timer.shutdownNow();
  }

  /** A call that is closed either by the service or by the timeout. */
  private static final class TimedCall<Q, A> extends SimpleForwardingServerCall<Q, A> {
    private boolean closed;

    TimedCall(ServerCall<Q, A> call) {
      super(call);
    }

    synchronized void timeOut() {
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
