package org.sitaf.server.history;

import java.util.ArrayList;
import java.util.List;
import javax.sql.DataSource;
import org.sitaf.core.compare.result.CaseIdentity;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.result.Results;
import org.sitaf.server.storage.DocumentMigration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.jdbc.core.JdbcTemplate;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;

/**
 * V191: fills the fingerprints of the cases of existing results from their documents, since rows of
 * large cases are shortened.
 */
@Component
class FingerprintMigration extends DocumentMigration {
  private static final Logger log = LoggerFactory.getLogger(FingerprintMigration.class);

  FingerprintMigration() {
    super("191", "fingerprints of cases");
  }

  @Override
  protected void migrate(DataSource database) {
    JdbcClient jdbc = JdbcClient.create(database);
    JdbcTemplate batches = new JdbcTemplate(database);
    for (String build : jdbc.sql("SELECT build_id FROM result").query(String.class).list()) {
      byte[] document =
          jdbc.sql("SELECT document FROM result WHERE build_id = ?")
              .param(build)
              .query((row, index) -> row.getBytes(1))
              .single();
      try {
        fill(batches, build, Results.read(document));
      } catch (InvalidInputException e) {
        log.warn("The history of cases leaves out build {}: its result cannot be read", build, e);
      }
    }
  }

  private static void fill(JdbcTemplate batches, String build, TestResult result) {
    List<String> fingerprints = CaseIdentity.fingerprints(result);
    List<Object[]> rows = new ArrayList<>(fingerprints.size());
    for (int i = 0; i < fingerprints.size(); i++) {
      rows.add(new Object[] {fingerprints.get(i), build, result.cases().get(i).no()});
    }
    batches.batchUpdate(
        "UPDATE result_case SET fingerprint = ? WHERE build_id = ? AND no = ?", rows);
  }
}
