package org.sitaf.server.access.enrolment;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.access.Backoff;
import org.sitaf.server.access.Secret;
import org.sitaf.server.audit.Audit;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.network.Addresses;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** Enrols agents and authenticates them by their keys. */
@Service
public class Enrolments {
  private static final String TOKEN_PREFIX = "sitaf-enrol_";
  private static final String KEY_PREFIX = "sitaf-agent_";
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9._-]{1,100}");
  private static final String COLUMNS =
      "SELECT id, agent, uses_left, created, created_by, expires FROM enrolment ";

  private final JdbcClient jdbc;
  private final TransactionTemplate transaction;
  private final AccessSettings settings;
  private final Audit audit;
  private final Clock clock;
  private final Backoff attempts = new Backoff(20, Duration.ofSeconds(1), Duration.ofMinutes(1));

  Enrolments(
      JdbcClient jdbc,
      TransactionTemplate transaction,
      AccessSettings settings,
      Audit audit,
      Clock clock) {
    this.jdbc = jdbc;
    this.transaction = transaction;
    this.settings = settings;
    this.audit = audit;
    this.clock = clock;
  }

  /** A new enrolment and its token, which is shown only once. */
  record WithSecret(Enrolment enrolment, String secret) {}

  /**
   * Enrols an agent.
   *
   * @param token an enrolment token, of which one use is consumed, or the launcher's
   * @return the agent's key
   * @throws EnrolmentException if the token is not valid for this agent
   * @throws RequestException if the name is invalid or the address made too many attempts
   */
  public String enrol(String token, String agent, String address) {
    String from = Addresses.group(address);
    Duration wait = attempts.attempt(from, clock.instant());
    if (!wait.isZero()) {
      audit.recordRejected("-", "enrol", agent, "refused: too often", address);
      throw RequestException.busy(
          "Too many failed enrolments from this address; try again in %d s."
              .formatted(Math.max(1, wait.toSeconds())));
    }
    if (!NAME.matcher(agent).matches()) {
      throw RequestException.malformed("name: must be 1 to 100 letters, digits, '.', '_' or '-'.");
    }
    String key = Secret.generate(KEY_PREFIX);
    try {
      transaction.executeWithoutResult(
          status -> {
            if (consume(token, agent)) {
              revoke(agent);
            }
            store(agent, key);
          });
    } catch (EnrolmentException e) {
      audit.recordRejected("-", "enrol", agent, "refused", address);
      throw e;
    }
    attempts.takeBack(from);
    audit.record(agent, "enrol", agent, "done", address);
    return key;
  }

  /** The agent that has this key. */
  public Optional<String> agentOf(String key) {
    return jdbc.sql("SELECT agent FROM agent_key WHERE hash = ?")
        .param(Secret.hash(key))
        .query(String.class)
        .optional();
  }

  /** Revokes an agent's key; returns whether it had one. */
  public boolean revoke(String agent) {
    return jdbc.sql("DELETE FROM agent_key WHERE agent = ?").param(agent).update() > 0;
  }

  WithSecret create(@Nullable String agent, int uses, Duration validFor, String createdBy) {
    if (agent != null && !NAME.matcher(agent).matches()) {
      throw RequestException.malformed("agent: must be 1 to 100 letters, digits, '.', '_' or '-'.");
    }
    String id = UUID.randomUUID().toString();
    String secret = Secret.generate(TOKEN_PREFIX);
    Instant now = clock.instant();
    jdbc.sql("DELETE FROM enrolment WHERE expires < ?").param(utc(now)).update();
    jdbc.sql(
            "INSERT INTO enrolment (id, hash, agent, uses_left, created, created_by, expires)"
                + " VALUES (?, ?, ?, ?, ?, ?, ?)")
        .params(id, Secret.hash(secret), agent, uses, utc(now), createdBy, utc(now.plus(validFor)))
        .update();
    return new WithSecret(find(id), secret);
  }

  List<Enrolment> list(PageRequest page) {
    return jdbc.sql(COLUMNS + "ORDER BY created DESC, id LIMIT ? OFFSET ?")
        .params(page.getPageSize(), page.getOffset())
        .query(Enrolments::enrolment)
        .list();
  }

  long count() {
    return jdbc.sql("SELECT COUNT(*) FROM enrolment").query(Long.class).single();
  }

  void delete(String id) {
    find(id);
    jdbc.sql("DELETE FROM enrolment WHERE id = ?").param(id).update();
  }

  private Enrolment find(String id) {
    return jdbc.sql(COLUMNS + "WHERE id = ?")
        .param(id)
        .query(Enrolments::enrolment)
        .optional()
        .orElseThrow(() -> RequestException.notFound("enrolment", id));
  }

  /** Consumes a use of the token; returns whether the agent may replace one of the same name. */
  private boolean consume(String token, String agent) {
    String launcher = settings.launcherEnrolment();
    if (launcher != null && Secret.same(token, launcher)) {
      return true;
    }
    String hash = Secret.hash(token);
    int used =
        jdbc.sql(
                "UPDATE enrolment SET uses_left = uses_left - 1 WHERE hash = ? AND uses_left > 0"
                    + " AND expires > ? AND (agent IS NULL OR agent = ?)")
            .params(hash, utc(clock.instant()), agent)
            .update();
    if (used == 0) {
      throw EnrolmentException.invalidToken();
    }
    return jdbc.sql("SELECT agent FROM enrolment WHERE hash = ?")
        .param(hash)
        .query((row, index) -> Objects.equals(row.getString(1), agent))
        .single();
  }

  private void store(String agent, String key) {
    try {
      jdbc.sql("INSERT INTO agent_key (agent, hash, created) VALUES (?, ?, ?)")
          .params(agent, Secret.hash(key), utc(clock.instant()))
          .update();
    } catch (DuplicateKeyException e) {
      throw EnrolmentException.nameTaken(agent);
    }
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  private static Enrolment enrolment(ResultSet row, int index) throws SQLException {
    return new Enrolment(
        row.getString(1),
        row.getString(2),
        row.getInt(3),
        row.getObject(4, OffsetDateTime.class).toInstant(),
        row.getString(5),
        row.getObject(6, OffsetDateTime.class).toInstant());
  }
}
