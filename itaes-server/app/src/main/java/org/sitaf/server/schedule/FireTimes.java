package org.sitaf.server.schedule;

import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageImpl;
import org.springframework.data.domain.Pageable;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** The history of schedules: their past fire times and the resulting builds. */
@Repository
class FireTimes {
  private static final int MAX_MESSAGE = 1000;

  private final JdbcClient jdbc;

  FireTimes(JdbcClient jdbc) {
    this.jdbc = jdbc;
  }

  /**
   * A past fire time.
   *
   * @param buildId null if no build was requested
   * @param buildState null if there is no build, or if it was deleted
   * @param message why no build was requested; empty if there is one
   */
  record FireTime(
      Instant fireTime,
      Instant noted,
      @Nullable String buildId,
      @Nullable String buildState,
      String message) {}

  boolean isRecorded(String scheduleId, Instant fireTime) {
    return jdbc.sql("SELECT COUNT(*) FROM schedule_fire WHERE schedule_id = ? AND fire_time = ?")
            .params(scheduleId, utc(fireTime))
            .query(Integer.class)
            .single()
        > 0;
  }

  /** Records a fire time, unless it is recorded already. */
  void record(
      String scheduleId, Instant fireTime, Instant now, @Nullable String buildId, String message) {
    try {
      jdbc.sql(
              "INSERT INTO schedule_fire (schedule_id, fire_time, noted, build_id, message)"
                  + " VALUES (?, ?, ?, ?, ?)")
          .params(
              scheduleId,
              utc(fireTime),
              utc(now),
              buildId,
              message.length() <= MAX_MESSAGE ? message : message.substring(0, MAX_MESSAGE))
          .update();
    } catch (DuplicateKeyException e) {
      // Another server recorded it first.
      return;
    }
  }

  /** The fire times of a schedule, newest first. */
  Page<FireTime> of(String scheduleId, Pageable page) {
    long total =
        jdbc.sql("SELECT COUNT(*) FROM schedule_fire WHERE schedule_id = ?")
            .param(scheduleId)
            .query(Long.class)
            .single();
    List<FireTime> items =
        jdbc.sql(
                "SELECT f.fire_time, f.noted, f.build_id, b.state, f.message FROM schedule_fire f"
                    + " LEFT JOIN build b ON b.id = f.build_id WHERE f.schedule_id = :schedule"
                    + " ORDER BY f.fire_time DESC LIMIT :size OFFSET :offset")
            .param("schedule", scheduleId)
            .param("size", page.getPageSize())
            .param("offset", page.getOffset())
            .query(
                (row, index) ->
                    new FireTime(
                        row.getObject(1, OffsetDateTime.class).toInstant(),
                        row.getObject(2, OffsetDateTime.class).toInstant(),
                        row.getString(3),
                        row.getString(4),
                        row.getString(5)))
            .list();
    return new PageImpl<>(items, page, total);
  }

  private static OffsetDateTime utc(Instant time) {
    return time.atOffset(ZoneOffset.UTC);
  }
}
