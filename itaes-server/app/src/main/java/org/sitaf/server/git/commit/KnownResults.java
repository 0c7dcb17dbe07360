package org.sitaf.server.git.commit;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** Results and suites that the database has already, so that they are not made again. */
@Repository
class KnownResults {
  private final JdbcClient jdbc;

  KnownResults(JdbcClient jdbc) {
    this.jdbc = jdbc;
  }

  /** A build whose result can be taken over, and the commit that it was made for. */
  record Reusable(String buildId, String sha) {}

  /**
   * The latest build that read the same bytes. A build that failed or is suspect is repeated, as it
   * could end otherwise. Code of the branch never gets a result that was made for a request, which
   * anyone may have written; neither does another request. What is built for a search has a low
   * priority, so nothing else waits for it.
   */
  Optional<Reusable> reusable(GitCommit commit, String model, String digest) {
    // No request has the number 0.
    int request = commit.mergeBase() ? 0 : Math.max(0, commit.requestNo());
    return jdbc.sql(
            "SELECT l.build_id, COALESCE(l.taken_from, c.sha) FROM git_cell l"
                + " JOIN git_commit c ON c.id = l.commit_id JOIN build b ON b.id = l.build_id"
                + " WHERE l.digest = ? AND c.source_id = ? AND l.model = ?"
                + " AND (c.request_no <= 0 OR c.merge_base = TRUE OR c.request_no = ?)"
                + " AND (c.request_no >= 0 OR b.finished IS NOT NULL)"
                + " AND b.state NOT IN ('FAILED', 'CANCELLED') AND b.suspicions IS NULL"
                + " ORDER BY c.received DESC LIMIT 1")
        .params(digest, commit.sourceId(), model, request)
        .query((row, no) -> new Reusable(row.getString(1), row.getString(2)))
        .optional();
  }

  /** The models that a search needs. */
  Set<String> modelsOfBisection(String sourceId, int number) {
    return Set.copyOf(
        jdbc.sql("SELECT model FROM git_bisection_model WHERE source_id = ? AND bisection_no = ?")
            .params(sourceId, number)
            .query(String.class)
            .list());
  }

  Optional<String> suite(String activityId, String model, String sha256) {
    return jdbc.sql(
            "SELECT suite_id FROM git_suite WHERE activity_id = ? AND model = ? AND sha256 = ?")
        .params(activityId, model, sha256)
        .query(String.class)
        .optional();
  }

  void insertSuite(String activityId, String model, String sha256, String suiteId) {
    jdbc.sql("INSERT INTO git_suite (activity_id, model, sha256, suite_id) VALUES (?, ?, ?, ?)")
        .params(activityId, model, sha256, suiteId)
        .update();
  }

  /** Releases of the agents and versions of their toolchains, which results can depend on. */
  List<String> toolchains() {
    return jdbc.sql(
            "SELECT DISTINCT a.version || ' ' || t.language || ' ' || t.version FROM agent a"
                + " JOIN agent_toolchain t ON t.agent_name = a.name ORDER BY 1")
        .query(String.class)
        .list();
  }
}
