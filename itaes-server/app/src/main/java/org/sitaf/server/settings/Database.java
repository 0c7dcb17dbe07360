package org.sitaf.server.settings;

import java.sql.Connection;
import java.sql.SQLException;
import javax.sql.DataSource;
import org.springframework.stereotype.Component;

/** The kind of database, which decides whether several servers can share it. */
@Component
public class Database {
  private final boolean shared;

  Database(DataSource database) throws SQLException {
    try (Connection connection = database.getConnection()) {
      shared = connection.getMetaData().getDatabaseProductName().equals("PostgreSQL");
    }
  }

  /** Whether other servers may use the same database: true for PostgreSQL, false for H2. */
  public boolean isShared() {
    return shared;
  }
}
