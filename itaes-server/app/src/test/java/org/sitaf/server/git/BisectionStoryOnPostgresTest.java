package org.sitaf.server.git;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.File;
import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.sitaf.server.support.ServerTest;
import org.springframework.test.annotation.DirtiesContext;
import org.springframework.test.context.DynamicPropertyRegistry;
import org.springframework.test.context.DynamicPropertySource;
import org.springframework.test.context.TestPropertySource;

/** Searches with PostgreSQL. */
@Tag("slow")
@DirtiesContext
@TestPropertySource(properties = ServerTest.OWN_SCHEDULER + "postgres-bisection")
class BisectionStoryOnPostgresTest extends BisectionStory {
  /** Runs longer than the server, which is closed after the class; a shutdown hook stops it. */
  private static final EmbeddedPostgres POSTGRES = start();

  @DynamicPropertySource
  static void database(DynamicPropertyRegistry registry) {
    registry.add("SITAF_DATABASE_URL", () -> POSTGRES.getJdbcUrl("postgres", "postgres"));
  }

  private static EmbeddedPostgres start() {
    try {
      // Not the folder for temporary files, which other programs of this machine unpack into.
      return EmbeddedPostgres.builder()
          .setOverrideWorkingDirectory(new File("target/postgres-bisection"))
          .start();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
