package org.sitaf.server.suite;

import java.util.Optional;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** Earlier revisions of suites, for undo. */
@Repository
class SuiteRevisions {
  /** Maximum number of revisions per suite. */
  static final int MAX_REVISIONS = 10;

  private final JdbcClient jdbc;

  SuiteRevisions(JdbcClient jdbc) {
    this.jdbc = jdbc;
  }

  /** Stores a revision, within the transaction that replaces it. */
  void push(String suiteId, long version, byte[] document) {
    jdbc.sql("INSERT INTO suite_revision (suite_id, version, document) VALUES (?, ?, ?)")
        .params(suiteId, version, document)
        .update();
    jdbc.sql(
            "DELETE FROM suite_revision WHERE suite_id = ? AND version NOT IN (SELECT version FROM"
                + " suite_revision WHERE suite_id = ? ORDER BY version DESC LIMIT ?)")
        .params(suiteId, suiteId, MAX_REVISIONS)
        .update();
  }

  /** Removes and returns the latest revision. */
  Optional<byte[]> pop(String suiteId) {
    Optional<Long> latest = latest(suiteId);
    return latest.flatMap(
        version -> {
          Optional<byte[]> document =
              jdbc.sql("SELECT document FROM suite_revision WHERE suite_id = ? AND version = ?")
                  .params(suiteId, version)
                  .query((row, index) -> row.getBytes(1))
                  .optional();
          jdbc.sql("DELETE FROM suite_revision WHERE suite_id = ? AND version = ?")
              .params(suiteId, version)
              .update();
          return document;
        });
  }

  /** The number of revisions. */
  int count(String suiteId) {
    return jdbc.sql("SELECT COUNT(*) FROM suite_revision WHERE suite_id = ?")
        .param(suiteId)
        .query(Integer.class)
        .single();
  }

  private Optional<Long> latest(String suiteId) {
    return jdbc.sql(
            "SELECT version FROM suite_revision WHERE suite_id = ? ORDER BY version DESC LIMIT 1")
        .param(suiteId)
        .query(Long.class)
        .optional();
  }
}
