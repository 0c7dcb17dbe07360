package org.sitaf.server.build;

import java.util.Optional;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/** The reports of analyses, as JSON documents. */
@Repository
class AnalysisReports {
  private final JdbcClient jdbc;

  AnalysisReports(JdbcClient jdbc) {
    this.jdbc = jdbc;
  }

  /** Stores a report within the transaction that ends the analysis. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void insert(String buildId, byte[] document) {
    jdbc.sql("INSERT INTO analysis (build_id, document) VALUES (?, ?)")
        .params(buildId, document)
        .update();
  }

  /** The report of an analysis; empty if it has none. */
  @Transactional(readOnly = true)
  public Optional<byte[]> find(String buildId) {
    return jdbc.sql("SELECT document FROM analysis WHERE build_id = ?")
        .param(buildId)
        .query((row, index) -> row.getBytes(1))
        .optional();
  }
}
