package org.sitaf.server.git.commit;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.git.remote.History;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** Commits of sources in the database, and the builds of their models. */
@Repository
public class CommitRows {
  private static final int MAX_PROBLEM = 3900;
  private static final String COLUMNS =
      "SELECT id, source_id, sha, request_no, position, subject, author, authored, received, ended,"
          + " state, problem, base_id, replaced, merge_base FROM git_commit ";
  private static final String CELLS =
      "SELECT c.commit_id, c.model, c.build_id, c.taken_from, b.state, b.suspicions, b.total,"
          + " b.pass, b.fail, b.error, b.failure_message, c.compared, c.differing"
          + " FROM git_cell c JOIN build b ON b.id = c.build_id ";

  private final JdbcClient jdbc;
  private final Clock clock;

  CommitRows(JdbcClient jdbc, Clock clock) {
    this.jdbc = jdbc;
    this.clock = clock;
  }

  public Optional<GitCommit> find(String id) {
    return jdbc.sql(COLUMNS + "WHERE id = ?").param(id).query(CommitRows::commit).optional();
  }

  /** A commit of the branch or else of a request, preferably one that was pushed to it. */
  public Optional<GitCommit> find(String sourceId, String sha) {
    return jdbc
        .sql(
            COLUMNS
                + "WHERE source_id = ? AND sha = ? AND request_no >= 0"
                + " ORDER BY merge_base, request_no")
        .params(sourceId, sha)
        .query(CommitRows::commit)
        .list()
        .stream()
        .findFirst();
  }

  /** A commit of the branch, of one request or of one search. */
  public Optional<GitCommit> find(String sourceId, int requestNo, String sha) {
    return jdbc.sql(COLUMNS + "WHERE source_id = ? AND request_no = ? AND sha = ?")
        .params(sourceId, requestNo, sha)
        .query(CommitRows::commit)
        .optional();
  }

  /** The commits of the branch that no force-push has removed, the newest first. */
  List<GitCommit> branch(String sourceId, int max) {
    return branchUpTo(sourceId, Long.MAX_VALUE, max);
  }

  /** The same up to a position. */
  public List<GitCommit> branchUpTo(String sourceId, long position, int max) {
    return jdbc.sql(
            COLUMNS
                + "WHERE source_id = ? AND request_no = 0 AND replaced = FALSE AND position <= ?"
                + " ORDER BY position DESC LIMIT ?")
        .params(sourceId, position, max)
        .query(CommitRows::commit)
        .list();
  }

  /** The commits of a branch or a request, the newest first. */
  public List<GitCommit> list(String sourceId, int requestNo, int size, long offset) {
    return jdbc.sql(
            COLUMNS
                + "WHERE source_id = ? AND request_no = ? ORDER BY position DESC LIMIT ? OFFSET ?")
        .params(sourceId, requestNo, size, offset)
        .query(CommitRows::commit)
        .list();
  }

  public long count(String sourceId, int requestNo) {
    return jdbc.sql("SELECT COUNT(*) FROM git_commit WHERE source_id = ? AND request_no = ?")
        .params(sourceId, requestNo)
        .query(Long.class)
        .single();
  }

  /** Those of some commits that belong to the branch, a request or a search. */
  public List<GitCommit> list(String sourceId, int requestNo, Collection<String> shas) {
    return shas.isEmpty()
        ? List.of()
        : jdbc.sql(
                COLUMNS + "WHERE source_id = :source AND request_no = :request AND sha IN (:shas)")
            .param("source", sourceId)
            .param("request", requestNo)
            .param("shas", shas)
            .query(CommitRows::commit)
            .list();
  }

  /** The number of commits of the branch between two of its commits that were left out. */
  public int notBuilt(GitCommit base, GitCommit commit) {
    if (commit.requestNo() != 0 || commit.position() - base.position() < 2) {
      return 0;
    }
    return jdbc.sql(
            "SELECT COUNT(*) FROM git_commit WHERE source_id = ? AND request_no = 0"
                + " AND replaced = FALSE AND state = 'SKIPPED' AND position > ? AND position < ?")
        .params(commit.sourceId(), base.position(), commit.position())
        .query(Integer.class)
        .single();
  }

  /** The newest heads of requests that were fetched. */
  public List<GitCommit> heads(String sourceId, Collection<Integer> requestNos) {
    return requestNos.isEmpty()
        ? List.of()
        : jdbc.sql(
                COLUMNS
                    + "c WHERE source_id = :source AND request_no IN (:requests)"
                    + " AND merge_base = FALSE AND NOT EXISTS (SELECT 1 FROM git_commit n"
                    + " WHERE n.source_id = c.source_id AND n.request_no = c.request_no"
                    + " AND n.merge_base = FALSE AND n.position > c.position)")
            .param("source", sourceId)
            .param("requests", requestNos)
            .query(CommitRows::commit)
            .list();
  }

  /**
   * Commits to build: those of the branch first and those of searches last, and each base before
   * what is compared with it.
   */
  public List<GitCommit> waiting(String sourceId) {
    return jdbc.sql(
            COLUMNS
                + "WHERE source_id = ? AND state = 'WAITING'"
                + " ORDER BY CASE WHEN request_no < 0 THEN 1 ELSE 0 END, request_no, position")
        .param(sourceId)
        .query(CommitRows::commit)
        .list();
  }

  /** Sources with commits that wait to be built. */
  List<String> sourcesWithWaiting() {
    return jdbc.sql("SELECT DISTINCT source_id FROM git_commit WHERE state = 'WAITING'")
        .query(String.class)
        .list();
  }

  /** Commits in state BUILDING of which no build runs any more, the oldest first. */
  List<String> ended() {
    return jdbc.sql(
            "SELECT c.id FROM git_commit c WHERE c.state = 'BUILDING' AND NOT EXISTS"
                + " (SELECT 1 FROM git_cell l JOIN build b ON b.id = l.build_id"
                + " WHERE l.commit_id = c.id AND b.finished IS NULL) ORDER BY c.position")
        .query(String.class)
        .list();
  }

  /** Inserts a commit and returns its id. */
  public String insert(
      String sourceId,
      int requestNo,
      boolean mergeBase,
      History.Commit commit,
      long position,
      GitCommit.State state,
      @Nullable String baseId) {
    String id = UUID.randomUUID().toString();
    jdbc.sql(
            "INSERT INTO git_commit (id, source_id, sha, request_no, merge_base, position, subject,"
                + " author, authored, received, state, base_id)"
                + " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .params(
            id,
            sourceId,
            commit.id(),
            requestNo,
            mergeBase,
            position,
            commit.subject(),
            commit.author(),
            utc(commit.time()),
            now(),
            state.name(),
            baseId)
        .update();
    return id;
  }

  public long nextPosition(String sourceId, int requestNo) {
    return jdbc.sql(
                "SELECT COALESCE(MAX(position), 0) FROM git_commit"
                    + " WHERE source_id = ? AND request_no = ?")
            .params(sourceId, requestNo)
            .query(Long.class)
            .single()
        + 1;
  }

  /** Marks what a force-push has removed from the branch: everything after a position. */
  void replacedAfter(String sourceId, long position) {
    jdbc.sql(
            "UPDATE git_commit SET replaced = TRUE WHERE source_id = ? AND request_no = 0"
                + " AND position > ?")
        .params(sourceId, position)
        .update();
    jdbc.sql(
            "UPDATE git_commit SET state = 'SKIPPED' WHERE source_id = ? AND request_no = 0"
                + " AND replaced = TRUE AND state = 'WAITING'")
        .param(sourceId)
        .update();
  }

  /** Removes a commit that a force-push had removed from the branch. */
  void deleteReplaced(String sourceId, String sha) {
    jdbc.sql(
            "DELETE FROM git_commit WHERE source_id = ? AND request_no = 0 AND sha = ?"
                + " AND replaced = TRUE")
        .params(sourceId, sha)
        .update();
  }

  /** Removes a commit that is built again. */
  public void delete(String id) {
    jdbc.sql("DELETE FROM git_commit WHERE id = ?").param(id).update();
  }

  /** Removes all commits of a request. */
  public void deleteRequest(String sourceId, int requestNo) {
    jdbc.sql("DELETE FROM git_commit WHERE source_id = ? AND request_no = ?")
        .params(sourceId, requestNo)
        .update();
  }

  /** Leaves out commits of the branch or a request that wait, since a later one is built. */
  public void skipWaiting(String sourceId, int requestNo) {
    jdbc.sql(
            "UPDATE git_commit SET state = 'SKIPPED' WHERE source_id = ? AND request_no = ?"
                + " AND state = 'WAITING'")
        .params(sourceId, requestNo)
        .update();
  }

  /**
   * Changes the state of a commit.
   *
   * @return false if it has another state than expected
   */
  boolean move(String id, GitCommit.State from, GitCommit.State to, @Nullable String problem) {
    boolean over = to == GitCommit.State.DONE || to == GitCommit.State.INVALID;
    return jdbc.sql(
                "UPDATE git_commit SET state = ?, problem = ?, ended = ?"
                    + " WHERE id = ? AND state = ?")
            .params(
                to.name(),
                problem == null
                    ? null
                    : problem.substring(0, Math.min(problem.length(), MAX_PROBLEM)),
                over ? now() : null,
                id,
                from.name())
            .update()
        == 1;
  }

  /** The cells of a commit, in the order of the models. */
  public List<GitCell> cells(String commitId) {
    return jdbc.sql(CELLS + "WHERE c.commit_id = ? ORDER BY c.position")
        .param(commitId)
        .query(CommitRows::cell)
        .list();
  }

  /** The cells of several commits. */
  public List<GitCell> cells(Collection<String> commitIds) {
    return commitIds.isEmpty()
        ? List.of()
        : jdbc.sql(CELLS + "WHERE c.commit_id IN (:commits) ORDER BY c.position, c.model")
            .param("commits", commitIds)
            .query(CommitRows::cell)
            .list();
  }

  /** Commits whose results a build gives. */
  List<String> ofBuild(String buildId) {
    return jdbc.sql("SELECT commit_id FROM git_cell WHERE build_id = ?")
        .param(buildId)
        .query(String.class)
        .list();
  }

  void insertCell(
      String commitId,
      String model,
      int position,
      String digest,
      String buildId,
      @Nullable String takenFrom) {
    jdbc.sql(
            "INSERT INTO git_cell (commit_id, model, position, digest, build_id, taken_from)"
                + " VALUES (?, ?, ?, ?, ?, ?)")
        .params(commitId, model, position, digest, buildId, takenFrom)
        .update();
  }

  void compared(String commitId, String model, int compared, int differing) {
    jdbc.sql("UPDATE git_cell SET compared = ?, differing = ? WHERE commit_id = ? AND model = ?")
        .params(compared, differing, commitId, model)
        .update();
  }

  private OffsetDateTime now() {
    return utc(clock.instant());
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  private static GitCommit commit(ResultSet row, int index) throws SQLException {
    OffsetDateTime ended = row.getObject(10, OffsetDateTime.class);
    return new GitCommit(
        row.getString(1),
        row.getString(2),
        row.getString(3),
        row.getInt(4),
        row.getLong(5),
        row.getString(6),
        row.getString(7),
        row.getObject(8, OffsetDateTime.class).toInstant(),
        row.getObject(9, OffsetDateTime.class).toInstant(),
        ended == null ? null : ended.toInstant(),
        GitCommit.State.valueOf(row.getString(11)),
        row.getString(12),
        row.getString(13),
        row.getBoolean(14),
        row.getBoolean(15));
  }

  private static GitCell cell(ResultSet row, int index) throws SQLException {
    return new GitCell(
        row.getString(1),
        row.getString(2),
        row.getString(3),
        row.getString(4),
        BuildState.valueOf(row.getString(5)),
        row.getString(6) != null,
        number(row, 7),
        number(row, 8),
        number(row, 9),
        number(row, 10),
        row.getString(11),
        number(row, 12),
        number(row, 13));
  }

  private static @Nullable Integer number(ResultSet row, int column) throws SQLException {
    int value = row.getInt(column);
    return row.wasNull() ? null : value;
  }
}
