package org.sitaf.server.computation;

import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import org.sitaf.server.access.Caller;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.springframework.boot.context.properties.EnableConfigurationProperties;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Service;

/**
 * Runs computations for requests, each in a thread that is interrupted when its time limit is
 * exceeded, when a later computation replaces it, or when the server stops.
 */
@Service
@EnableConfigurationProperties(ComputationSettings.class)
public class Computations implements SmartLifecycle {
  private static final Duration BETWEEN_HEARTBEATS = Duration.ofMillis(500);

  private final ComputationSettings settings;
  private final ComputationPermits permits;
  private ExecutorService threads = threads();
  private volatile boolean running;

  Computations(ComputationSettings settings) {
    this.settings = settings;
    this.permits = new ComputationPermits(settings.permits());
  }

  /**
   * Computes a preview. A later preview of the same user replaces it.
   *
   * @param heartbeat called every half second while the preview is computed; an exception from it
   *     cancels the preview
   * @throws ComputationTimeoutException if it exceeds its time limit
   * @throws RequestException if the server is busy, or the computation is cancelled
   */
  public <T> T preview(String what, Supplier<T> work, Runnable heartbeat) {
    return run(what, settings.preview(), true, work, heartbeat);
  }

  /**
   * Computes a result that will be stored.
   *
   * @throws ComputationTimeoutException if it exceeds its time limit
   * @throws RequestException if the server is busy, or the computation is cancelled
   */
  public <T> T generation(String what, Supplier<T> work) {
    return run(what, settings.generation(), false, work, () -> {});
  }

  private <T> T run(
      String what, Duration limit, boolean replaceable, Supplier<T> work, Runnable heartbeat) {
    FutureTask<T> task = null;
    try {
      ComputationPermits.Permit permit =
          permits.acquire(Caller.currentName(), replaceable, settings.queueTimeout());
      task = new Computation<>(work, permit);
      if (replaceable) {
        FutureTask<T> started = task;
        permit.onReplace(() -> started.cancel(true));
      }
      start(task, permit);
      return await(task, what, limit, heartbeat);
    } catch (CancellationException | RejectedExecutionException e) {
      throw cancelled(what);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw cancelled(what);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof CancellationException) {
        throw cancelled(what);
      }
      if (e.getCause() instanceof RuntimeException failure) {
        throw failure;
      }
      if (e.getCause() instanceof OutOfMemoryError) {
        throw RequestException.tooLarge(what + " needs more memory than the server has.");
      }
      throw new IllegalStateException(what + " failed", e.getCause());
    } finally {
      if (task != null) {
        task.cancel(true);
      }
    }
  }

  private static <T> T await(FutureTask<T> task, String what, Duration limit, Runnable heartbeat)
      throws InterruptedException, ExecutionException {
    long deadline = System.nanoTime() + limit.toNanos();
    for (long left = limit.toNanos(); left > 0; left = deadline - System.nanoTime()) {
      try {
        return task.get(Math.min(left, BETWEEN_HEARTBEATS.toNanos()), TimeUnit.NANOSECONDS);
      } catch (TimeoutException e) {
        heartbeat.run();
      }
    }
    throw new ComputationTimeoutException(what, Math.max(1, limit.toSeconds()));
  }

  private void start(FutureTask<?> task, ComputationPermits.Permit permit) {
    try {
      threads.execute(task);
    } catch (RejectedExecutionException e) {
      permits.release(permit);
      throw e;
    }
  }

  private RequestException cancelled(String what) {
    return RequestException.busy(
        what
            + (running
                ? " was cancelled because you sent a later request."
                : " was cancelled because the server is stopping."));
  }

  /** Releases its permit when the work has ended, which may be after the request has ended. */
  private final class Computation<T> extends FutureTask<T> {
    private final ComputationPermits.Permit permit;

    Computation(Supplier<T> work, ComputationPermits.Permit permit) {
      super(work::get);
      this.permit = permit;
    }

    @Override
    public void run() {
      try {
        super.run();
      } finally {
        permits.release(permit);
      }
    }
  }

  private static ExecutorService threads() {
    return Executors.newCachedThreadPool(
        work -> {
          Thread thread = new Thread(work, "computation");
          thread.setDaemon(true);
          return thread;
        });
  }

  @Override
  public void start() {
    if (threads.isShutdown()) {
      threads = threads();
    }
    running = true;
  }

  @Override
  public void stop() {
    running = false;
    threads.shutdownNow();
  }

  @Override
  public boolean isRunning() {
    return running;
  }

  /** Stops before the web server, which waits for its requests. */
  @Override
  public int getPhase() {
    return Integer.MAX_VALUE;
  }
}
