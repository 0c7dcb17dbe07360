import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;

/** A PostgreSQL server that lives for as long as standard input is open; prints its JDBC address. */
public final class Postgres {
  private Postgres() {}

  public static void main(String[] arguments) throws Exception {
    try (EmbeddedPostgres postgres = EmbeddedPostgres.builder().setServerConfig("max_connections", "200").start()) {
      System.out.println(postgres.getJdbcUrl("postgres", "postgres"));
      while (System.in.read() >= 0) {
        // Only the end counts.
      }
    }
  }
}
