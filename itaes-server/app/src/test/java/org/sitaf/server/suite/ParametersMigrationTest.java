package org.sitaf.server.suite;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.sql.Connection;
import java.sql.DriverManager;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.MigrationContext;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.jdbc.datasource.SingleConnectionDataSource;

class ParametersMigrationTest {
  @Test
  void parametersAreReadFromTheDocuments() throws Exception {
    TestSuite suite =
        TestCaseGenerator.generate(
                Activity.read(FileTree.of(Activities.files())).models().get(0),
                new GenerationOptions(null, null, 1, Effort.DEFAULT))
            .suite();
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    TestSuiteXml.write(suite, document);
    try (Connection connection = DriverManager.getConnection("jdbc:h2:mem:suites")) {
      JdbcClient jdbc = JdbcClient.create(new SingleConnectionDataSource(connection, true));
      jdbc.sql("CREATE TABLE suite (id VARCHAR)").update();
      jdbc.sql("INSERT INTO suite VALUES ('one')").update();
      jdbc.sql("CREATE TABLE suite_document (suite_id VARCHAR, document BLOB)").update();
      jdbc.sql("INSERT INTO suite_document VALUES ('one', ?)")
          .param(document.toByteArray())
          .update();
      jdbc.sql(
              "CREATE TABLE suite_parameter (suite_id VARCHAR, position INT, name VARCHAR,"
                  + " kind VARCHAR, real_type VARCHAR)")
          .update();
      new ParametersMigration().migrate(new MigrationContext(connection));
      assertThat(
              jdbc.sql("SELECT name FROM suite_parameter WHERE suite_id = 'one' ORDER BY position")
                  .query(String.class)
                  .list())
          .containsExactlyElementsOf(suite.parameters().stream().map(p -> p.name()).toList())
          .hasSize(3);
    }
  }
}
