package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.File;
import java.io.IOException;
import java.sql.Connection;
import javax.sql.DataSource;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.ServerTest;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.test.annotation.DirtiesContext;
import org.springframework.test.context.DynamicPropertyRegistry;
import org.springframework.test.context.DynamicPropertySource;
import org.springframework.test.context.TestPropertySource;

/** Builds with PostgreSQL. */
@Tag("slow")
@DirtiesContext
@TestPropertySource(properties = ServerTest.OWN_SCHEDULER + "postgres")
class BuildStoryOnPostgresTest extends BuildStory {
  /** Runs longer than the server, which is closed after the class; a shutdown hook stops it. */
  private static final EmbeddedPostgres POSTGRES = start();

  @Autowired private DataSource database;

  @DynamicPropertySource
  static void database(DynamicPropertyRegistry registry) {
    registry.add("SITAF_DATABASE_URL", () -> POSTGRES.getJdbcUrl("postgres", "postgres"));
  }

  @Test
  void databaseIsPostgresql() throws Exception {
    try (Connection connection = database.getConnection()) {
      assertThat(connection.getMetaData().getDatabaseProductName()).isEqualTo("PostgreSQL");
    }
  }

  private static EmbeddedPostgres start() {
    try {
      // Not the folder for temporary files, which other programs of this machine unpack into as
      // well.
      return EmbeddedPostgres.builder()
          .setOverrideWorkingDirectory(new File("target/postgres"))
          .start();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
