package org.sitaf.server.file;

import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Component;

/** Periodically deletes file contents that are no longer referenced. */
@Component
class FileCollection implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(FileCollection.class);
  private static final long INITIAL_DELAY_MIN = 5;
  private static final long INTERVAL_MIN = 30;

  private final StoredFiles files;
  private ScheduledExecutorService timer = DaemonTimer.named("file-collection");
  private volatile boolean running;

  FileCollection(StoredFiles files) {
    this.files = files;
  }

  private void collect() {
    try {
      int deleted = files.deleteUnreferenced();
      if (deleted > 0) {
        log.info("Deleted {} unreferenced file contents", deleted);
      }
    } catch (RuntimeException e) {
      if (running) {
        log.warn("Unreferenced file contents could not be deleted; retrying later", e);
      }
    }
  }

  @Override
  public void start() {
    if (timer.isShutdown()) {
      timer = DaemonTimer.named("file-collection");
    }
    running = true;
    var unused =
        timer.scheduleWithFixedDelay(
            this::collect, INITIAL_DELAY_MIN, INTERVAL_MIN, TimeUnit.MINUTES);
  }

  @Override
  public void stop() {
    running = false;
    timer.shutdownNow();
  }

  @Override
  public boolean isRunning() {
    return running;
  }
}
