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
import org.sitaf.server.refusal.OvertimeException;
import org.sitaf.server.refusal.Refusal;
import org.springframework.boot.context.properties.EnableConfigurationProperties;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Service;

/**
 * Runs computations for requests: in a thread of its own each, which is interrupted when its time
 * is over, when a later one takes its place, and when the server stops.
 */
@Service
@EnableConfigurationProperties(ComputationSettings.class)
public class Computations implements SmartLifecycle {
  private final ComputationSettings settings;
  private final Places places;
  private ExecutorService threads = threads();
  private volatile boolean running;

  Computations(ComputationSettings settings) {
    this.settings = settings;
    this.places = new Places(settings.places());
  }

  /**
   * What a preview shows. A later preview of the same person may end it, since that person looks at
   * the later one.
   *
   * @throws OvertimeException when it takes too long
   * @throws Refusal when the server has no place for it, or it is ended
   */
  public <T> T preview(String what, Supplier<T> work) {
    return run(what, settings.preview(), true, work);
  }

  /**
   * What is kept.
   *
   * @throws OvertimeException when it takes too long
   * @throws Refusal when the server has no place for it, or it is ended
   */
  public <T> T generation(String what, Supplier<T> work) {
    return run(what, settings.generation(), false, work);
  }

  private <T> T run(String what, Duration limit, boolean replaceable, Supplier<T> work) {
    FutureTask<T> task = null;
    try {
      Places.Place place = places.take(Caller.currentName(), replaceable, settings.patience());
      task = new Computation<>(work, place);
      if (replaceable) {
        FutureTask<T> ended = task;
        place.replaceableBy(() -> ended.cancel(true));
      }
      start(task, place);
      return task.get(limit.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      throw new OvertimeException(what, Math.max(1, limit.toSeconds()));
    } catch (CancellationException | RejectedExecutionException e) {
      throw ended(what);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw ended(what);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof CancellationException) {
        throw ended(what);
      }
      if (e.getCause() instanceof RuntimeException failure) {
        throw failure;
      }
      if (e.getCause() instanceof OutOfMemoryError) {
        throw Refusal.tooLarge(what + " takes more memory than this server has.");
      }
      throw new IllegalStateException(what + " failed", e.getCause());
    } finally {
      if (task != null) {
        task.cancel(true);
      }
    }
  }

  private void start(FutureTask<?> task, Places.Place place) {
    try {
      threads.execute(task);
    } catch (RejectedExecutionException e) {
      places.free(place);
      throw e;
    }
  }

  private Refusal ended(String what) {
    return Refusal.busy(
        what
            + (running
                ? " was ended, since a later request of yours took its place."
                : " was ended, since the server stops."));
  }

  /** Keeps its place until the work has ended, which may be after nobody waits for it any more. */
  private final class Computation<T> extends FutureTask<T> {
    private final Runnable free;

    Computation(Supplier<T> work, Places.Place place) {
      super(work::get);
      this.free = () -> places.free(place);
    }

    @Override
    public void run() {
      try {
        super.run();
      } finally {
        free.run();
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

  /** Before the web server, which waits for its requests. */
  @Override
  public int getPhase() {
    return Integer.MAX_VALUE;
  }
}
