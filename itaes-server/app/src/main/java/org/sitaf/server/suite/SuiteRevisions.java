package org.sitaf.server.suite;

import java.util.Optional;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** What suites were before their latest changes. */
@Repository
class SuiteRevisions {
  /** Revisions that are kept of a suite. */
  static final int KEPT = 10;

  private final JdbcClient jdbc;

  SuiteRevisions(JdbcClient jdbc) {
    this.jdbc = jdbc;
  }

  /** Keeps a document that is about to be replaced, within the transaction that replaces it. */
  void push(String suiteId, long version, byte[] document) {
    jdbc.sql("INSERT INTO suite_revision (suite_id, version, document) VALUES (?, ?, ?)")
        .params(suiteId, version, document)
        .update();
    jdbc.sql(
            "DELETE FROM suite_revision WHERE suite_id = ? AND version NOT IN (SELECT version FROM"
                + " suite_revision WHERE suite_id = ? ORDER BY version DESC LIMIT ?)")
        .params(suiteId, suiteId, KEPT)
        .update();
  }

  /** Takes the latest document that was kept. */
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

  /** How many changes can be undone. */
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
