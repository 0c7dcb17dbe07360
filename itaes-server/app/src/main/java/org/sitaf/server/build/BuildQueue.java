package org.sitaf.server.build;

import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.settings.Database;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/** The queue of builds. It is part of the database, so that several servers can share it. */
@Repository
public class BuildQueue {
  private static final String READY =
      " FROM build WHERE state = 'QUEUED' AND shards = 0"
          + " AND (not_before IS NULL OR not_before <= :now)";

  private final JdbcClient jdbc;
  private final String claim;

  BuildQueue(JdbcClient jdbc, Database database) {
    this.jdbc = jdbc;
    // H2 has a single server, and SKIP LOCKED is slow there.
    this.claim =
        "SELECT id FROM build WHERE id = ? AND state = 'QUEUED' AND shards = 0 FOR UPDATE"
            + (database.isShared() ? " SKIP LOCKED" : "");
  }

  /** A queued build that can be assigned to an agent. */
  public record QueuedBuild(
      String id, String activityId, Requirements requirements, int priority, Instant created) {}

  /**
   * The distinct requirements of the queued builds whose delay has ended.
   *
   * @param now the same for all queries of one look at the queue: a build whose delay ends between
   *     two of them would be neither ready nor delayed
   */
  @Transactional(readOnly = true)
  public List<Requirements> requirements(Instant now) {
    return jdbc
        .sql("SELECT DISTINCT requirements" + READY)
        .param("now", utc(now))
        .query(String.class)
        .list()
        .stream()
        .map(Requirements::parse)
        .toList();
  }

  /**
   * The first queued builds of each activity with one of the given requirements.
   *
   * @param limit maximum number per activity and requirements
   */
  @Transactional(readOnly = true)
  public List<QueuedBuild> first(Collection<Requirements> requirements, int limit, Instant now) {
    return jdbc.sql(
            "SELECT id, activity_id, requirements, priority, created FROM ("
                + "SELECT id, activity_id, requirements, priority, created,"
                + " ROW_NUMBER() OVER (PARTITION BY activity_id, requirements"
                + " ORDER BY priority DESC, created, id) AS place"
                + READY
                + " AND requirements IN (:requirements)) ready WHERE place <= :limit")
        .param("now", utc(now))
        .param("requirements", requirements.stream().map(Requirements::text).toList())
        .param("limit", limit)
        .query(
            (row, index) ->
                new QueuedBuild(
                    row.getString(1),
                    row.getString(2),
                    Requirements.parse(row.getString(3)),
                    row.getInt(4),
                    row.getObject(5, OffsetDateTime.class).toInstant()))
        .list();
  }

  /** The number of running builds of each activity. */
  @Transactional(readOnly = true)
  public Map<String, Integer> active() {
    Map<String, Integer> active = new HashMap<>();
    jdbc.sql(
            "SELECT activity_id, COUNT(*) FROM build WHERE shards = 0 AND state IN"
                + " ('LEASED', 'PREPARING', 'COMPILING', 'RUNNING', 'UPLOADING')"
                + " GROUP BY activity_id")
        .query((row, index) -> active.put(row.getString(1), row.getInt(2)))
        .list();
    return active;
  }

  /** When the delay of the next delayed build ends. */
  @Transactional(readOnly = true)
  public Optional<Instant> nextDelayEnd(Instant now) {
    return jdbc.sql(
            "SELECT not_before FROM build"
                + " WHERE state = 'QUEUED' AND shards = 0 AND not_before > :now"
                + " ORDER BY not_before LIMIT 1")
        .param("now", utc(now))
        .query((row, index) -> row.getObject(1, OffsetDateTime.class).toInstant())
        .optional();
  }

  /**
   * Locks a queued build for the current transaction, without waiting for other servers.
   *
   * @return false if the build is no longer queued, or if another server has locked it
   */
  @Transactional(propagation = Propagation.MANDATORY)
  public boolean claim(String buildId) {
    return jdbc.sql(claim).param(buildId).query(String.class).optional().isPresent();
  }

  private static OffsetDateTime utc(Instant time) {
    return time.atOffset(ZoneOffset.UTC);
  }
}
