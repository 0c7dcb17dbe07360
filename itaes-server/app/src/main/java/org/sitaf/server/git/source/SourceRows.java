package org.sitaf.server.git.source;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.settings.Database;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** Git sources in the database. */
@Repository
public class SourceRows {
  private static final int MAX_PROBLEM = 3900;
  private static final String COLUMNS =
      "SELECT id, activity_id, url, branch, folder, credential_kind, credential_user, secret,"
          + " host_key, policy, interval_s, version, created, head, fetched, problem,"
          + " problem_since, forge, api_url, project, forge_secret, hook_secret FROM git_source ";

  private final JdbcClient jdbc;
  private final Clock clock;

  /** Names this process as the one that works on a source. */
  private final String self = UUID.randomUUID().toString();

  SourceRows(JdbcClient jdbc, Database database, Clock clock) {
    this.jdbc = jdbc;
    this.clock = clock;
    if (!database.isShared()) {
      // Claims of a process that died.
      jdbc.sql("UPDATE git_source SET claimed_by = NULL, claimed_until = NULL").update();
    }
  }

  public Optional<GitSource> find(String id) {
    return jdbc.sql(COLUMNS + "WHERE id = ?").param(id).query(SourceRows::source).optional();
  }

  public Optional<GitSource> ofActivity(String activityId) {
    return jdbc.sql(COLUMNS + "WHERE activity_id = ?")
        .param(activityId)
        .query(SourceRows::source)
        .optional();
  }

  public List<GitSource> all() {
    return jdbc.sql(COLUMNS).query(SourceRows::source).list();
  }

  void insert(GitSource source) {
    jdbc.sql(
            "INSERT INTO git_source (id, activity_id, url, branch, folder, credential_kind,"
                + " credential_user, secret, host_key, policy, interval_s, version, created, forge,"
                + " api_url, project, forge_secret)"
                + " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .params(
            source.id(),
            source.activityId(),
            source.url(),
            source.branch(),
            source.folder(),
            source.credentialKind().name(),
            source.credentialUser(),
            source.encryptedSecret(),
            source.hostKey(),
            source.policy().name(),
            source.intervalS(),
            source.version(),
            utc(source.created()),
            forge(source),
            source.project() == null ? null : source.project().api(),
            source.project() == null ? null : source.project().path(),
            source.encryptedForgeSecret())
        .update();
  }

  /**
   * Replaces the settings.
   *
   * @param version that the row must have
   * @return false if it has another one
   */
  boolean update(GitSource source, long version) {
    return jdbc.sql(
                "UPDATE git_source SET url = ?, branch = ?, folder = ?, credential_kind = ?,"
                    + " credential_user = ?, secret = ?, host_key = ?, policy = ?, interval_s = ?,"
                    + " forge = ?, api_url = ?, project = ?, forge_secret = ?,"
                    + " version = version + 1, problem = NULL, problem_since = NULL"
                    + " WHERE id = ? AND version = ?")
            .params(
                source.url(),
                source.branch(),
                source.folder(),
                source.credentialKind().name(),
                source.credentialUser(),
                source.encryptedSecret(),
                source.hostKey(),
                source.policy().name(),
                source.intervalS(),
                forge(source),
                source.project() == null ? null : source.project().api(),
                source.project() == null ? null : source.project().path(),
                source.encryptedForgeSecret(),
                source.id(),
                version)
            .update()
        == 1;
  }

  private static String forge(GitSource source) {
    ForgeProject project = source.project();
    return (project == null ? Forge.NONE : project.forge()).name();
  }

  /** Replaces the secret that signs the forge's messages. */
  void hookSecret(String id, String encrypted) {
    jdbc.sql("UPDATE git_source SET hook_secret = ? WHERE id = ?").params(encrypted, id).update();
  }

  void delete(String id) {
    jdbc.sql("DELETE FROM git_source WHERE id = ?").param(id).update();
  }

  /** Stores that the branch was fetched. */
  public void fetched(String id, @Nullable String hostKey) {
    jdbc.sql(
            "UPDATE git_source SET fetched = ?, problem = NULL, problem_since = NULL,"
                + " host_key = COALESCE(?, host_key) WHERE id = ?")
        .params(now(), hostKey, id)
        .update();
  }

  /** Stores the newest commit that was read. */
  public void head(String id, String commit) {
    jdbc.sql("UPDATE git_source SET head = ? WHERE id = ?").params(commit, id).update();
  }

  /** Stores why the branch could not be fetched; the last good state stays. */
  public void failed(String id, String problem) {
    jdbc.sql(
            "UPDATE git_source SET problem = ?, problem_since = COALESCE(problem_since, ?)"
                + " WHERE id = ?")
        .params(problem.substring(0, Math.min(problem.length(), MAX_PROBLEM)), now(), id)
        .update();
  }

  /**
   * Claims a source, so that only one of several servers works on it.
   *
   * @return false if another one does
   */
  public boolean claim(String id, Duration time) {
    return jdbc.sql(
                "UPDATE git_source SET claimed_by = :self, claimed_until = :until WHERE id = :id"
                    + " AND (claimed_until IS NULL OR claimed_until < :now OR claimed_by = :self)")
            .param("self", self)
            .param("until", utc(clock.instant().plus(time)))
            .param("now", now())
            .param("id", id)
            .update()
        == 1;
  }

  public void release(String id) {
    jdbc.sql(
            "UPDATE git_source SET claimed_by = NULL, claimed_until = NULL"
                + " WHERE id = ? AND claimed_by = ?")
        .params(id, self)
        .update();
  }

  private OffsetDateTime now() {
    return utc(clock.instant());
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  private static @Nullable Instant instant(ResultSet row, int column) throws SQLException {
    OffsetDateTime time = row.getObject(column, OffsetDateTime.class);
    return time == null ? null : time.toInstant();
  }

  private static GitSource source(ResultSet row, int index) throws SQLException {
    Forge forge = Forge.valueOf(row.getString(18));
    return new GitSource(
        row.getString(1),
        row.getString(2),
        row.getString(3),
        row.getString(4),
        row.getString(5),
        GitSource.CredentialKind.valueOf(row.getString(6)),
        row.getString(7),
        row.getString(8),
        row.getString(9),
        GitSource.Policy.valueOf(row.getString(10)),
        row.getInt(11),
        row.getLong(12),
        row.getObject(13, OffsetDateTime.class).toInstant(),
        row.getString(14),
        instant(row, 15),
        row.getString(16),
        instant(row, 17),
        forge == Forge.NONE ? null : new ForgeProject(forge, row.getString(19), row.getString(20)),
        row.getString(21),
        row.getString(22));
  }
}
