package org.sitaf.server.file;

import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Component;

/** Has contents collected that nothing refers to any more, now and then. */
@Component
class FileCollection implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(FileCollection.class);
  private static final long FIRST_MIN = 5;
  private static final long EVERY_MIN = 30;

  private final StoredFiles files;
  private ScheduledExecutorService timer = DaemonTimer.named("file-collection");
  private volatile boolean running;

  FileCollection(StoredFiles files) {
    this.files = files;
  }

  private void collect() {
    try {
      int collected = files.collect();
      if (collected > 0) {
        log.info("Collected {} file contents that nothing referred to", collected);
      }
    } catch (RuntimeException e) {
      if (running) {
        log.warn("File contents could not be collected; trying again later", e);
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
        timer.scheduleWithFixedDelay(this::collect, FIRST_MIN, EVERY_MIN, TimeUnit.MINUTES);
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
