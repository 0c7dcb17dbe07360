package org.sitaf.server.build.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.server.support.MigrationContext;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.jdbc.datasource.SingleConnectionDataSource;

class LogFilesMigrationTest {
  @TempDir private Path folder;

  @Test
  void logFilesAreImportedUpToTheirLength() throws Exception {
    String large = "x".repeat(BuildLogs.MAX_CHUNK) + "end";
    Files.writeString(folder.resolve("large.log"), large);
    Files.writeString(folder.resolve("torn.log"), "acknowledged, and not");
    try (Connection connection = DriverManager.getConnection("jdbc:h2:mem:logs")) {
      JdbcClient jdbc = JdbcClient.create(new SingleConnectionDataSource(connection, true));
      jdbc.sql("CREATE TABLE build (id VARCHAR, log_length BIGINT)").update();
      jdbc.sql("CREATE TABLE build_log (build_id VARCHAR, start_at BIGINT, size INT, bytes BLOB)")
          .update();
      jdbc.sql("INSERT INTO build VALUES ('large', ?), ('torn', 12), ('lost', 7), ('empty', 0)")
          .param(large.length())
          .update();
      new LogFilesMigration(folder).migrate(new MigrationContext(connection));
      assertThat(log(jdbc, "large")).isEqualTo(large);
      assertThat(log(jdbc, "torn")).isEqualTo("acknowledged");
      assertThat(log(jdbc, "lost")).isEmpty();
    }
  }

  private static String log(JdbcClient jdbc, String build) {
    return String.join(
        "",
        jdbc.sql("SELECT bytes FROM build_log WHERE build_id = ? ORDER BY start_at")
            .param(build)
            .query((row, index) -> new String(row.getBytes(1), StandardCharsets.UTF_8))
            .list());
  }
}
