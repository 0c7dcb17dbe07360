package org.sitaf.server.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.DriverManager;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.compare.result.CaseIdentity;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.result.Results;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.MigrationContext;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.jdbc.datasource.SingleConnectionDataSource;

class FingerprintMigrationTest {
  private static byte[] document() {
    Activity activity = Activity.read(FileTree.of(Activities.files()));
    return FakeAgent.result(
        InterfaceTestApplicationGenerator.generate(
            activity,
            activity.models().get(0),
            TestCaseGenerator.generate(
                    activity.models().get(0), new GenerationOptions(null, null, 1, Effort.DEFAULT))
                .suite()),
        List.of());
  }

  @Test
  void casesOfExistingResultsGetTheirFingerprints() throws Exception {
    byte[] document = document();
    TestResult result = Results.read(document);
    try (Connection connection = DriverManager.getConnection("jdbc:h2:mem:fingerprints")) {
      JdbcClient jdbc = JdbcClient.create(new SingleConnectionDataSource(connection, true));
      jdbc.sql("CREATE TABLE result (build_id VARCHAR, document BLOB)").update();
      jdbc.sql("CREATE TABLE result_case (build_id VARCHAR, no INT, fingerprint VARCHAR)").update();
      jdbc.sql("INSERT INTO result VALUES ('one', ?), ('unreadable', ?)")
          .params(document, "<no_result/>".getBytes(StandardCharsets.UTF_8))
          .update();
      result
          .cases()
          .forEach(
              each ->
                  jdbc.sql("INSERT INTO result_case VALUES ('one', ?, NULL)")
                      .param(each.no())
                      .update());
      new FingerprintMigration().migrate(new MigrationContext(connection));
      assertThat(
              jdbc.sql("SELECT fingerprint FROM result_case WHERE build_id = 'one' ORDER BY no")
                  .query(String.class)
                  .list())
          .hasSize(55)
          .isEqualTo(CaseIdentity.fingerprints(result));
    }
  }
}
