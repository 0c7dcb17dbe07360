package org.sitaf.server.git.request;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.git.source.Forge;
import org.sitaf.server.git.source.GitSource;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/**
 * Pull and merge requests in the database. What a fetch finds is stored only if the head is still
 * the one that was to be fetched: a message may have reported another one in the meantime.
 */
@Repository
class RequestRows {
  private static final int MAX_PROBLEM = 3900;
  private static final String COLUMNS =
      "SELECT source_id, request_no, forge, title, author, head, is_fork, state, received, updated,"
          + " asked_head, asked_by, asked, recorded_head, problem FROM git_request ";
  private static final String FILTERED = "WHERE source_id = ? AND state = COALESCE(?, state)";

  private final JdbcClient jdbc;
  private final Clock clock;

  RequestRows(JdbcClient jdbc, Clock clock) {
    this.jdbc = jdbc;
    this.clock = clock;
  }

  Optional<GitRequest> find(String sourceId, int number) {
    return jdbc.sql(COLUMNS + "WHERE source_id = ? AND request_no = ?")
        .params(sourceId, number)
        .query(RequestRows::request)
        .optional();
  }

  /**
   * Requests of a source, those with the highest numbers first.
   *
   * @param state null for any
   */
  List<GitRequest> list(String sourceId, GitRequest.@Nullable State state, int size, long offset) {
    return jdbc.sql(COLUMNS + FILTERED + " ORDER BY request_no DESC LIMIT ? OFFSET ?")
        .params(sourceId, name(state), size, offset)
        .query(RequestRows::request)
        .list();
  }

  long count(String sourceId, GitRequest.@Nullable State state) {
    return jdbc.sql("SELECT COUNT(*) FROM git_request " + FILTERED)
        .params(sourceId, name(state))
        .query(Long.class)
        .single();
  }

  /** Requests whose heads have to be fetched: of forks only those that somebody asked for. */
  List<GitRequest> toFetch(String sourceId, int maxFailures) {
    return jdbc.sql(
            COLUMNS
                + "WHERE source_id = ? AND state = 'OPEN' AND failures < ?"
                + " AND (recorded_head IS NULL OR recorded_head <> head)"
                + " AND (is_fork = FALSE OR asked_head = head) ORDER BY request_no")
        .params(sourceId, maxFailures)
        .query(RequestRows::request)
        .list();
  }

  /** Stores what a forge has reported. */
  void report(GitSource source, ReportedRequest reported, GitRequest.State state) {
    if (!update(source, reported, state)) {
      try {
        insert(source, reported, state);
      } catch (DuplicateKeyException e) {
        boolean unused = update(source, reported, state);
      }
    }
  }

  private boolean update(GitSource source, ReportedRequest reported, GitRequest.State state) {
    return jdbc.sql(
                "UPDATE git_request SET forge = :forge, title = :title,"
                    + " problem = CASE WHEN head = :head THEN problem ELSE NULL END, head = :head,"
                    + " is_fork = :fork, state = :state, updated = :now, failures = 0"
                    + " WHERE source_id = :source AND request_no = :number")
            .param("forge", reported.forge().name())
            .param("title", reported.title())
            .param("head", reported.head())
            .param("fork", reported.fork())
            .param("state", state.name())
            .param("now", now())
            .param("source", source.id())
            .param("number", reported.number())
            .update()
        == 1;
  }

  private void insert(GitSource source, ReportedRequest reported, GitRequest.State state) {
    jdbc.sql(
            "INSERT INTO git_request (source_id, request_no, url, branch, forge, title, author,"
                + " head, is_fork, state, received, updated, failures)"
                + " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 0)")
        .params(
            source.id(),
            reported.number(),
            source.url(),
            source.branch(),
            reported.forge().name(),
            reported.title(),
            reported.author(),
            reported.head(),
            reported.fork(),
            state.name(),
            now(),
            now())
        .update();
  }

  /**
   * Stores who asked to build a head.
   *
   * @return false if the request is closed or has another head
   */
  boolean ask(String sourceId, int number, String head, String by) {
    return jdbc.sql(
                "UPDATE git_request SET asked_head = head, asked_by = ?, asked = ?,"
                    + " recorded_head = NULL, failures = 0, problem = NULL"
                    + " WHERE source_id = ? AND request_no = ? AND head = ? AND state = 'OPEN'")
            .params(by, now(), sourceId, number, head)
            .update()
        == 1;
  }

  /**
   * Stores that the commits of a head were recorded.
   *
   * @param head that was fetched, which can be newer than the one that was to be fetched
   * @param problem why it cannot be built
   * @return false if the request was closed or has got another head in the meantime
   */
  boolean recorded(GitRequest request, String head, @Nullable String problem) {
    return jdbc.sql(
                "UPDATE git_request SET head = ?, recorded_head = ?, failures = 0, problem = ?"
                    + " WHERE source_id = ? AND request_no = ? AND head = ? AND state = 'OPEN'")
            .params(
                head,
                head,
                shortened(problem),
                request.sourceId(),
                request.number(),
                request.head())
            .update()
        == 1;
  }

  /** Stores that commits of a request were left out, so that the head is recorded again. */
  void notRecorded(String sourceId, int number) {
    jdbc.sql("UPDATE git_request SET recorded_head = NULL WHERE source_id = ? AND request_no = ?")
        .params(sourceId, number)
        .update();
  }

  /** Stores that the head of a fork is another one than the one that somebody asked for. */
  void moved(GitRequest request, String head, String problem) {
    jdbc.sql(
            "UPDATE git_request SET head = ?, problem = ?"
                + " WHERE source_id = ? AND request_no = ? AND head = ?")
        .params(head, problem, request.sourceId(), request.number(), request.head())
        .update();
  }

  /** Stores why the head could not be fetched. */
  void failed(GitRequest request, String problem) {
    jdbc.sql(
            "UPDATE git_request SET failures = failures + 1, problem = ?"
                + " WHERE source_id = ? AND request_no = ? AND head = ?")
        .params(shortened(problem), request.sourceId(), request.number(), request.head())
        .update();
  }

  /** Numbers of requests into another branch or repository than the source has now. */
  List<Integer> ofOtherBranches(GitSource source) {
    return jdbc.sql(
            "SELECT request_no FROM git_request WHERE source_id = ? AND (url <> ? OR branch <> ?)")
        .params(source.id(), source.url(), source.branch())
        .query(Integer.class)
        .list();
  }

  void delete(String sourceId, int number) {
    jdbc.sql("DELETE FROM git_request WHERE source_id = ? AND request_no = ?")
        .params(sourceId, number)
        .update();
  }

  private static @Nullable String name(GitRequest.@Nullable State state) {
    return state == null ? null : state.name();
  }

  private static @Nullable String shortened(@Nullable String problem) {
    return problem == null ? null : problem.substring(0, Math.min(problem.length(), MAX_PROBLEM));
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }

  private static GitRequest request(ResultSet row, int index) throws SQLException {
    OffsetDateTime asked = row.getObject(13, OffsetDateTime.class);
    return new GitRequest(
        row.getString(1),
        row.getInt(2),
        Forge.valueOf(row.getString(3)),
        row.getString(4),
        row.getString(5),
        row.getString(6),
        row.getBoolean(7),
        GitRequest.State.valueOf(row.getString(8)),
        instant(row, 9),
        instant(row, 10),
        row.getString(11),
        row.getString(12),
        asked == null ? null : asked.toInstant(),
        row.getString(14),
        row.getString(15));
  }

  private static Instant instant(ResultSet row, int column) throws SQLException {
    return row.getObject(column, OffsetDateTime.class).toInstant();
  }
}
