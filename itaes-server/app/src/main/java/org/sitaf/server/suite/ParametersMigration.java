package org.sitaf.server.suite;

import java.io.ByteArrayInputStream;
import java.util.List;
import javax.sql.DataSource;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.server.storage.DocumentMigration;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;

/** V91: fills the parameters of existing suites from their documents. */
@Component
class ParametersMigration extends DocumentMigration {
  ParametersMigration() {
    super("91", "parameters of suites");
  }

  @Override
  protected void migrate(DataSource database) {
    JdbcClient jdbc = JdbcClient.create(database);
    for (String id : jdbc.sql("SELECT id FROM suite").query(String.class).list()) {
      byte[] document =
          jdbc.sql("SELECT document FROM suite_document WHERE suite_id = ?")
              .param(id)
              .query((row, index) -> row.getBytes(1))
              .single();
      List<CaseParameter> parameters =
          TestSuiteXml.read(new ByteArrayInputStream(document), "suite " + id).parameters();
      for (int position = 0; position < parameters.size(); position++) {
        CaseParameter parameter = parameters.get(position);
        jdbc.sql(
                "INSERT INTO suite_parameter (suite_id, position, name, kind, real_type)"
                    + " VALUES (?, ?, ?, ?, ?)")
            .params(id, position, parameter.name(), parameter.kind().name(), parameter.realType())
            .update();
      }
    }
  }
}
