package org.sitaf.server.web;

import java.io.IOException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.boot.SpringApplication;
import org.springframework.boot.autoconfigure.condition.ConditionalOnBooleanProperty;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Component;

/** Stops the server when its standard input is closed, such as when its launcher dies. */
@Component
@ConditionalOnBooleanProperty("sitaf.stop-with-stdin")
class StopWithStdin {
  private static final Logger log = LoggerFactory.getLogger(StopWithStdin.class);

  @EventListener
  void on(ApplicationReadyEvent ready) {
    Thread watcher =
        new Thread(
            () -> {
              waitForEnd();
              System.exit(SpringApplication.exit(ready.getApplicationContext()));
            },
            "stdin");
    watcher.setDaemon(true);
    watcher.start();
  }

  private static void waitForEnd() {
    try {
      while (System.in.read() >= 0) {
        // Ignore the input and wait for its end.
      }
    } catch (IOException e) {
      log.info("Standard input cannot be read: {}", e.getMessage());
    }
  }
}
