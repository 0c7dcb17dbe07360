import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.File;

/**
 * A PostgreSQL server that lives for as long as standard input is open; prints its JDBC address. The argument is the folder of its
 * programs, which are unpacked where it is empty, and of its data.
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
        // Only the end counts.
      }
    }
  }
}
