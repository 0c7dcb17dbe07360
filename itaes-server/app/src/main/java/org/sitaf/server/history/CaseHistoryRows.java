package org.sitaf.server.history;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.OffsetDateTime;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.git.commit.GitCommit;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;
import tools.jackson.databind.json.JsonMapper;

/** Reads cases across builds; a page is one statement. */
@Repository
class CaseHistoryRows {
  /** Of builds that test all that was requested; shards and analyses are left out. */
  private static final String TESTS =
      " b.activity_id = :activity AND b.model = :model AND b.kind = 'TEST'"
          + " AND b.parent_id IS NULL ";

  private static final String CASE =
      " b.id, b.state, b.failure_message, b.suspicions, b.total, r.outcome";

  private static final String JOINED_CASE =
      " LEFT JOIN result_case r ON r.build_id = b.id AND r.fingerprint = :fingerprint ";

  private static final String OF_COMMITS =
      "SELECT c.sha, c.subject, c.author, c.authored, c.replaced, l.taken_from, c.state, c.problem,"
          + CASE
          + " FROM git_commit c"
          + " LEFT JOIN git_cell l ON l.commit_id = c.id AND l.model = :model"
          + " LEFT JOIN build b ON b.id = l.build_id"
          + JOINED_CASE
          + "WHERE c.source_id = :source AND c.request_no = 0 ";

  /** A build of some cases is no point of the line of another case. */
  private static final String BUILDS =
      " FROM build b"
          + JOINED_CASE
          + "WHERE"
          + TESTS
          + "AND (b.case_numbers IS NULL OR r.no IS NOT NULL) ";

  private static final String OF_BUILDS =
      "SELECT b.commit_id, '', '', b.created, FALSE, NULL, NULL, NULL," + CASE + BUILDS;

  private final JdbcClient jdbc;
  private final JsonMapper json;

  CaseHistoryRows(JdbcClient jdbc, JsonMapper json) {
    this.jdbc = jdbc;
    this.json = json;
  }

  /**
   * A case in all builds.
   *
   * @param sourceId of the Git source; null for the line through builds
   */
  record Line(String activityId, @Nullable String sourceId, String model, String fingerprint) {}

  /** The build of a model with the newest result. */
  Optional<String> newest(String activityId, String model) {
    return jdbc.sql(
            "SELECT b.id FROM build b WHERE"
                + TESTS
                + "AND b.total IS NOT NULL ORDER BY b.created DESC, b.id DESC LIMIT 1")
        .param("activity", activityId)
        .param("model", model)
        .query(String.class)
        .optional();
  }

  /** The build of a model with the result of the newest commit of a branch. */
  Optional<String> newestOfBranch(String sourceId, String model) {
    return jdbc.sql(
            "SELECT b.id FROM git_commit c"
                + " JOIN git_cell l ON l.commit_id = c.id AND l.model = ?"
                + " JOIN build b ON b.id = l.build_id"
                + " WHERE c.source_id = ? AND c.request_no = 0 AND c.replaced = FALSE"
                + " AND b.total IS NOT NULL ORDER BY c.position DESC LIMIT 1")
        .params(model, sourceId)
        .query(String.class)
        .optional();
  }

  boolean isOf(String activityId, String model, String buildId) {
    return jdbc.sql("SELECT COUNT(*) FROM build b WHERE b.id = :build AND" + TESTS)
            .param("build", buildId)
            .param("activity", activityId)
            .param("model", model)
            .query(Long.class)
            .single()
        > 0;
  }

  /** A case with the fingerprint that identifies it; null if its result could not be read. */
  record Identified(CaseResult result, @Nullable String fingerprint) {}

  Optional<Identified> find(String buildId, int no) {
    return jdbc.sql("SELECT outcome, fingerprint FROM result_case WHERE build_id = ? AND no = ?")
        .params(buildId, no)
        .query((row, index) -> new Identified(result(row.getString(1)), row.getString(2)))
        .optional();
  }

  long count(Line line) {
    String sql =
        line.sourceId() == null
            ? "SELECT COUNT(*)" + BUILDS
            : "SELECT COUNT(*) FROM git_commit WHERE source_id = :source AND request_no = 0";
    return statement(sql, line).query(Long.class).single();
  }

  /** The points of a line, the newest first. */
  List<CasePoint> points(Line line, int size, long offset) {
    String sql =
        line.sourceId() == null
            ? OF_BUILDS + "ORDER BY b.created DESC, b.id DESC"
            : OF_COMMITS + "ORDER BY c.position DESC";
    return statement(sql + " LIMIT :size OFFSET :offset", line)
        .param("size", size)
        .param("offset", offset)
        .query(line.sourceId() == null ? this::ofBuild : this::ofCommit)
        .list();
  }

  /** The newest point before another one that has a result, and no force-push has removed. */
  Optional<CasePoint> judgedBefore(Line line, CasePoint point) {
    CasePoint.Subject commit = point.commit();
    String sql =
        line.sourceId() == null
            ? OF_BUILDS
                + "AND r.no IS NOT NULL"
                + " AND (b.created, b.id) < (SELECT created, id FROM build WHERE id = :build)"
                + " ORDER BY b.created DESC, b.id DESC LIMIT 1"
            : OF_COMMITS
                + "AND r.no IS NOT NULL AND c.replaced = FALSE"
                + " AND c.position < (SELECT position FROM git_commit"
                + " WHERE source_id = :source AND request_no = 0 AND sha = :commit)"
                + " ORDER BY c.position DESC LIMIT 1";
    return statement(sql, line)
        .param("build", point.buildId())
        .param("commit", commit == null ? null : commit.sha())
        .query(line.sourceId() == null ? this::ofBuild : this::ofCommit)
        .optional();
  }

  /** SHA-256 of the documents with the cases of builds, several for a build with shards. */
  Map<String, TreeSet<String>> suites(Collection<String> buildIds) {
    Map<String, TreeSet<String>> suites = new HashMap<>();
    if (!buildIds.isEmpty()) {
      jdbc.sql(
              "SELECT COALESCE(b.parent_id, b.id), f.sha256 FROM build b"
                  + " JOIN build_file f ON f.build_id = b.id AND f.path = 'suite.xml'"
                  + " WHERE (b.id IN (:builds) AND b.shards = 0) OR b.parent_id IN (:builds)")
          .param("builds", buildIds)
          .query(
              row -> {
                suites
                    .computeIfAbsent(row.getString(1), id -> new TreeSet<>())
                    .add(row.getString(2));
              });
    }
    return suites;
  }

  private JdbcClient.StatementSpec statement(String sql, Line line) {
    return jdbc.sql(sql)
        .param("activity", line.activityId())
        .param("source", line.sourceId())
        .param("model", line.model())
        .param("fingerprint", line.fingerprint());
  }

  private CasePoint ofCommit(ResultSet row, int index) throws SQLException {
    return point(row, GitCommit.State.valueOf(row.getString(7)));
  }

  private CasePoint ofBuild(ResultSet row, int index) throws SQLException {
    return point(row, null);
  }

  private CasePoint point(ResultSet row, GitCommit.@Nullable State commit) throws SQLException {
    String sha = row.getString(1);
    String buildId = row.getString(9);
    String outcome = row.getString(14);
    CaseResult result = outcome == null ? null : result(outcome);
    CasePoint.State state;
    String reason = "";
    if (result != null) {
      state = CasePoint.State.JUDGED;
    } else if (buildId == null) {
      state = withoutBuild(commit);
      reason =
          switch (state) {
            case INVALID -> String.valueOf(row.getString(8));
            case ABSENT -> "The commit does not have this test model.";
            case PENDING -> "The commit is being built.";
            default -> "The commit was not built, since later ones were pushed before its turn.";
          };
    } else if (row.getObject(13) != null) {
      state = CasePoint.State.ABSENT;
      reason = "The build has no case with these inputs.";
    } else if (BuildState.valueOf(row.getString(10)).isOver()) {
      state = CasePoint.State.NO_RESULT;
      String failure = row.getString(11);
      reason = failure == null ? "The build was cancelled." : failure;
    } else {
      state = CasePoint.State.PENDING;
      reason = "The build has not ended.";
    }
    return new CasePoint(
        sha == null ? null : new CasePoint.Subject(sha, row.getString(2), row.getString(3)),
        row.getObject(4, OffsetDateTime.class).toInstant(),
        row.getBoolean(5),
        buildId,
        row.getString(6),
        row.getString(12) != null,
        state,
        reason,
        result);
  }

  private static CasePoint.State withoutBuild(GitCommit.@Nullable State commit) {
    return switch (Objects.requireNonNull(commit, "a build has an id")) {
      case INVALID -> CasePoint.State.INVALID;
      case SKIPPED -> CasePoint.State.NOT_BUILT;
      case WAITING, BUILDING -> CasePoint.State.PENDING;
      case DONE -> CasePoint.State.ABSENT;
    };
  }

  private CaseResult result(String outcome) {
    return json.readValue(outcome, CaseResult.class);
  }
}
