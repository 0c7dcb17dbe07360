package org.sitaf.server.build;

import java.time.Clock;
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

/**
 * The builds that wait. The database is the queue; several servers may take from it at the same
 * time.
 */
@Repository
public class BuildQueue {
  private static final String READY =
      " FROM build WHERE state = 'QUEUED' AND parts = 0"
          + " AND (not_before IS NULL OR not_before <= :now)";

  private final JdbcClient jdbc;
  private final Clock clock;
  private final String claim;

  BuildQueue(JdbcClient jdbc, Database database, Clock clock) {
    this.jdbc = jdbc;
    this.clock = clock;
    // H2 has one server alone, and takes its time over SKIP LOCKED.
    this.claim =
        "SELECT id FROM build WHERE id = ? AND state = 'QUEUED' AND parts = 0 FOR UPDATE"
            + (database.isShared() ? " SKIP LOCKED" : "");
  }

  /** A build that may be given to an agent. */
  public record Waiting(
      String id, String activityId, Requirements requirements, int priority, Instant created) {}

  /** What the builds ask for that wait now, each once. */
  @Transactional(readOnly = true)
  public List<Requirements> requirements() {
    return jdbc
        .sql("SELECT DISTINCT requirements" + READY)
        .param("now", now())
        .query(String.class)
        .list()
        .stream()
        .map(Requirements::parse)
        .toList();
  }

  /**
   * The first builds of each activity that ask for one of these.
   *
   * @param atMost of an activity and requirement
   */
  @Transactional(readOnly = true)
  public List<Waiting> first(Collection<Requirements> requirements, int atMost) {
    return jdbc.sql(
            "SELECT id, workspace_id, requirements, priority, created FROM ("
                + "SELECT id, workspace_id, requirements, priority, created,"
                + " ROW_NUMBER() OVER (PARTITION BY workspace_id, requirements"
                + " ORDER BY priority DESC, created, id) AS place"
                + READY
                + " AND requirements IN (:requirements)) ready WHERE place <= :atMost")
        .param("now", now())
        .param("requirements", requirements.stream().map(Requirements::text).toList())
        .param("atMost", atMost)
        .query(
            (row, index) ->
                new Waiting(
                    row.getString(1),
                    row.getString(2),
                    Requirements.parse(row.getString(3)),
                    row.getInt(4),
                    row.getObject(5, OffsetDateTime.class).toInstant()))
        .list();
  }

  /** How many builds of each activity agents work on. */
  @Transactional(readOnly = true)
  public Map<String, Integer> active() {
    Map<String, Integer> active = new HashMap<>();
    jdbc.sql(
            "SELECT workspace_id, COUNT(*) FROM build WHERE parts = 0 AND state IN"
                + " ('LEASED', 'PREPARING', 'COMPILING', 'RUNNING', 'UPLOADING')"
                + " GROUP BY workspace_id")
        .query((row, index) -> active.put(row.getString(1), row.getInt(2)))
        .list();
    return active;
  }

  /** When the next build that was put off may be given to an agent. */
  @Transactional(readOnly = true)
  public Optional<Instant> nextPutOff() {
    return jdbc.sql(
            "SELECT not_before FROM build"
                + " WHERE state = 'QUEUED' AND parts = 0 AND not_before > :now"
                + " ORDER BY not_before LIMIT 1")
        .param("now", now())
        .query((row, index) -> row.getObject(1, OffsetDateTime.class).toInstant())
        .optional();
  }

  /**
   * Locks a waiting build for this transaction. Where another server is about to take it, this one
   * goes on to the next instead of waiting.
   *
   * @return false when it does not wait any more
   */
  @Transactional(propagation = Propagation.MANDATORY)
  public boolean claim(String buildId) {
    return jdbc.sql(claim).param(buildId).query(String.class).optional().isPresent();
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }
}
