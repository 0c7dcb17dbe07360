import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.File;

/**
 * Runs a PostgreSQL server until standard input is closed; prints its JDBC address. The argument is the folder of its
 * programs, which are unpacked if it is empty, and of its data.
 */
public final class Postgres {
  private Postgres() {}

  public static void main(String[] arguments) throws Exception {
    try (EmbeddedPostgres postgres =
        EmbeddedPostgres.builder()
            .setOverrideWorkingDirectory(new File(arguments[0]))
            .setServerConfig("max_connections", "200")
            .start()) {
      System.out.println(postgres.getJdbcUrl("postgres", "postgres"));
      while (System.in.read() >= 0) {
        // The content is ignored.
      }
    }
  }
}
