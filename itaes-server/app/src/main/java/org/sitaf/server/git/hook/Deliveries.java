package org.sitaf.server.git.hook;

import java.time.Clock;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Repository;

/** The messages that were accepted. */
@Repository("gitDeliveries")
class Deliveries {
  private static final Duration KEPT = Duration.ofDays(30);

  private final JdbcClient jdbc;
  private final DiskSpace disk;
  private final Clock clock;

  Deliveries(JdbcClient jdbc, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.disk = disk;
    this.clock = clock;
  }

  /**
   * Records a message.
   *
   * @return false if it was recorded before
   */
  boolean isNew(String sourceId, String id) {
    try {
      return jdbc.sql(
                  "INSERT INTO git_hook_delivery (source_id, delivery, received) VALUES (?, ?, ?)")
              .params(sourceId, id, now())
              .update()
          == 1;
    } catch (DuplicateKeyException e) {
      return false;
    }
  }

  @Scheduled(fixedDelayString = "PT6H", initialDelayString = "PT10M")
  void deleteOld() {
    if (disk.canWrite()) {
      jdbc.sql("DELETE FROM git_hook_delivery WHERE received < ?")
          .param(now().minus(KEPT))
          .update();
    }
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }
}
