package org.sitaf.server.access.token;

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
import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Role;
import org.sitaf.server.access.Secret;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.LimitSettings;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;

/** API tokens, with which scripts authenticate. */
@Service
public class ApiTokens {
  private static final String PREFIX = "sitaf_";
  private static final int MAX_NAME = 100;

  /** Resolution of {@link ApiToken#lastUsed}, so that not every request writes to the database. */
  private static final Duration LAST_USED_RESOLUTION = Duration.ofMinutes(1);

  private static final String COLUMNS =
      "SELECT t.id, t.name, p.id, p.name, t.role, t.created, t.expires, t.last_used, p.role"
          + " FROM api_token t JOIN person p ON p.id = t.person_id ";

  private final JdbcClient jdbc;
  private final AccessSettings settings;
  private final LimitSettings limits;
  private final DiskSpace disk;
  private final Clock clock;

  ApiTokens(
      JdbcClient jdbc, AccessSettings settings, LimitSettings limits, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.settings = settings;
    this.limits = limits;
    this.disk = disk;
    this.clock = clock;
  }

  /** A new token and its secret, which is shown only once. */
  record WithSecret(ApiToken token, String secret) {}

  private record Use(ApiToken token, Role ownersRole) {}

  /** The caller with this secret; empty if the token is unknown, revoked or expired. */
  public Optional<Caller> caller(String secret) {
    String launcher = settings.launcherToken();
    if (launcher != null && Secret.same(secret, launcher)) {
      return Optional.of(new Caller("launcher", Role.ADMINISTRATOR, Caller.Kind.LAUNCHER, null));
    }
    Instant now = clock.instant();
    return jdbc.sql(COLUMNS + "WHERE t.hash = ? AND t.expires > ? AND p.enabled = TRUE")
        .params(Secret.hash(secret), utc(now))
        .query((row, index) -> new Use(token(row, index), Role.valueOf(row.getString(9))))
        .optional()
        .map(
            use -> {
              noteUse(use.token(), now);
              return new Caller(
                  use.token().owner(),
                  use.token().role().atMost(use.ownersRole()),
                  Caller.Kind.TOKEN,
                  use.token().ownerId());
            });
  }

  /** Creates a token that expires after the given time. */
  WithSecret create(String personId, String name, Role role, Duration validFor) {
    if (name.isBlank() || name.length() > MAX_NAME) {
      throw RequestException.malformed("name: must be 1 to " + MAX_NAME + " characters.");
    }
    if (count(personId) >= limits.tokens()) {
      throw RequestException.conflict(
          "You have %d of at most %d tokens; revoke one that you no longer need."
              .formatted(count(personId), limits.tokens()));
    }
    String id = UUID.randomUUID().toString();
    String secret = Secret.generate(PREFIX);
    Instant now = clock.instant();
    jdbc.sql(
            "INSERT INTO api_token (id, person_id, name, role, hash, created, expires)"
                + " VALUES (?, ?, ?, ?, ?, ?, ?)")
        .params(
            id,
            personId,
            name.strip(),
            role.name(),
            Secret.hash(secret),
            utc(now),
            utc(now.plus(validFor)))
        .update();
    return new WithSecret(find(id), secret);
  }

  ApiToken find(String id) {
    return jdbc.sql(COLUMNS + "WHERE t.id = ?")
        .param(id)
        .query(ApiTokens::token)
        .optional()
        .orElseThrow(() -> RequestException.notFound("token", id));
  }

  void revoke(String id) {
    jdbc.sql("DELETE FROM api_token WHERE id = ?").param(id).update();
  }

  /** Tokens, newest first, of one owner or, with null, of all. */
  List<ApiToken> list(@Nullable String ownerId, PageRequest page) {
    return jdbc.sql(
            COLUMNS
                + "WHERE p.id = COALESCE(?, p.id) ORDER BY t.created DESC, t.id LIMIT ? OFFSET ?")
        .params(ownerId, page.getPageSize(), page.getOffset())
        .query(ApiTokens::token)
        .list();
  }

  long count(@Nullable String ownerId) {
    return jdbc.sql("SELECT COUNT(*) FROM api_token WHERE person_id = COALESCE(?, person_id)")
        .param(ownerId)
        .query(Long.class)
        .single();
  }

  private void noteUse(ApiToken token, Instant now) {
    boolean known =
        token.lastUsed().filter(last -> last.plus(LAST_USED_RESOLUTION).isAfter(now)).isPresent();
    if (!known && disk.canWrite()) {
      jdbc.sql("UPDATE api_token SET last_used = ? WHERE id = ?")
          .params(utc(now), token.id())
          .update();
    }
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  private static ApiToken token(ResultSet row, int index) throws SQLException {
    OffsetDateTime lastUsed = row.getObject(8, OffsetDateTime.class);
    @Nullable Instant last = lastUsed == null ? null : lastUsed.toInstant();
    return new ApiToken(
        row.getString(1),
        row.getString(2),
        row.getString(3),
        row.getString(4),
        Role.valueOf(row.getString(5)),
        row.getObject(6, OffsetDateTime.class).toInstant(),
        row.getObject(7, OffsetDateTime.class).toInstant(),
        last);
  }
}
