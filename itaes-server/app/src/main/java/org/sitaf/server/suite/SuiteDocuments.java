package org.sitaf.server.suite;

import java.util.Optional;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** The current documents of suites. */
@Repository
class SuiteDocuments {
  private final JdbcClient jdbc;

  SuiteDocuments(JdbcClient jdbc) {
    this.jdbc = jdbc;
  }

  Optional<byte[]> find(String suiteId) {
    return jdbc.sql("SELECT document FROM suite_document WHERE suite_id = ?")
        .param(suiteId)
        .query((row, index) -> row.getBytes(1))
        .optional();
  }

  /** Stores the document of a suite, within the transaction that changes the suite. */
  void save(String suiteId, byte[] document) {
    int replaced =
        jdbc.sql("UPDATE suite_document SET document = ? WHERE suite_id = ?")
            .params(document, suiteId)
            .update();
    if (replaced == 0) {
      jdbc.sql("INSERT INTO suite_document (suite_id, document) VALUES (?, ?)")
          .params(suiteId, document)
          .update();
    }
  }
}
