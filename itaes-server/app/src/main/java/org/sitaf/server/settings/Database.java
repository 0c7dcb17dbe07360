package org.sitaf.server.settings;

import java.sql.Connection;
import java.sql.SQLException;
import javax.sql.DataSource;
import org.springframework.stereotype.Component;

/** Which database there is, and so whether this server is alone with it. */
@Component
public class Database {
  private final boolean shared;

  Database(DataSource database) throws SQLException {
    try (Connection connection = database.getConnection()) {
      shared = connection.getMetaData().getDatabaseProductName().equals("PostgreSQL");
    }
  }

  /** Whether other servers may work with the same database: with PostgreSQL, not with H2. */
  public boolean isShared() {
    return shared;
  }
}
