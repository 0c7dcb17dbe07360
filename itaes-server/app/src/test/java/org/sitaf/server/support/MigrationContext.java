package org.sitaf.server.support;

import java.sql.Connection;
import org.flywaydb.core.api.configuration.ClassicConfiguration;
import org.flywaydb.core.api.configuration.Configuration;
import org.flywaydb.core.api.migration.Context;

/** The context of a Java migration. */
public record MigrationContext(Connection connection) implements Context {
  @Override
  public Configuration getConfiguration() {
    return new ClassicConfiguration();
  }

  @Override
  public Connection getConnection() {
    return connection;
  }
}
