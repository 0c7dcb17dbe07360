package org.sitaf.server.storage;

import javax.sql.DataSource;
import org.flywaydb.core.api.MigrationVersion;
import org.flywaydb.core.api.migration.Context;
import org.flywaydb.core.api.migration.JavaMigration;
import org.jspecify.annotations.Nullable;
import org.springframework.jdbc.datasource.SingleConnectionDataSource;

/** A migration from documents or files, which SQL cannot read. It runs in one transaction. */
public abstract class DocumentMigration implements JavaMigration {
  private final MigrationVersion version;
  private final String description;

  /**
   * A migration that stays as it is once it was released.
   *
   * @param version its place among the migrations, such as {@code 93}
   */
  protected DocumentMigration(String version, String description) {
    this.version = MigrationVersion.fromVersion(version);
    this.description = description;
  }

  /** Migrates the database; its one connection stays open. */
  protected abstract void migrate(DataSource database);

  @Override
  public final MigrationVersion getVersion() {
    return version;
  }

  @Override
  public final String getDescription() {
    return description;
  }

  @Override
  public final @Nullable Integer getChecksum() {
    return null;
  }

  @Override
  public final boolean canExecuteInTransaction() {
    return true;
  }

  @Override
  public final void migrate(Context context) {
    migrate(new SingleConnectionDataSource(context.getConnection(), true));
  }
}
