package org.sitaf.server.access.user;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.UUID;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Role;
import org.sitaf.server.error.RequestException;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.session.FindByIndexNameSessionRepository;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** The users. The last enabled administrator can be neither disabled nor deleted. */
@Service
public class Users {
  private static final Pattern NAME = Pattern.compile("[a-z0-9][a-z0-9._@-]{0,59}");
  private static final String COLUMNS =
      "SELECT id, name, role, enabled, created, last_sign_in FROM person ";

  private final JdbcClient jdbc;
  private final TransactionTemplate transaction;
  private final Passwords passwords;
  private final FindByIndexNameSessionRepository<?> sessions;
  private final ApplicationEventPublisher events;
  private final Clock clock;

  Users(
      JdbcClient jdbc,
      TransactionTemplate transaction,
      Passwords passwords,
      FindByIndexNameSessionRepository<?> sessions,
      ApplicationEventPublisher events,
      Clock clock) {
    this.jdbc = jdbc;
    this.transaction = transaction;
    this.passwords = passwords;
    this.sessions = sessions;
    this.events = events;
    this.clock = clock;
  }

  /** A user's password was changed. */
  record PasswordChange(User user) {}

  /** A user and a generated password, which is shown only once. */
  public record WithPassword(User user, String password) {}

  /** Checks name and password; empty if they are wrong or the user is disabled. */
  public Optional<User> signIn(String name, String password) {
    String known = normal(name);
    String hash =
        jdbc.sql("SELECT password_hash FROM person WHERE name = ? AND enabled = TRUE")
            .param(known)
            .query((row, index) -> Optional.ofNullable(row.getString(1)))
            .optional()
            .flatMap(found -> found)
            .orElse(null);
    if (!passwords.matches(password, hash)) {
      return Optional.empty();
    }
    return byName(known).map(this::signedIn);
  }

  /** Stores the time of the user's last sign-in. */
  public User signedIn(User user) {
    jdbc.sql("UPDATE person SET last_sign_in = ? WHERE id = ?").params(now(), user.id()).update();
    return find(user.id());
  }

  public Optional<User> byName(String name) {
    return jdbc.sql(COLUMNS + "WHERE name = ?").param(normal(name)).query(Users::user).optional();
  }

  /**
   * Returns a user.
   *
   * @throws RequestException if there is no user with this id
   */
  public User find(String id) {
    return jdbc.sql(COLUMNS + "WHERE id = ?")
        .param(id)
        .query(Users::user)
        .optional()
        .orElseThrow(() -> RequestException.notFound("user", id));
  }

  /** The oldest administrator who is enabled. */
  public Optional<User> firstAdministrator() {
    return jdbc.sql(
            COLUMNS
                + "WHERE role = 'ADMINISTRATOR' AND enabled = TRUE ORDER BY created, id LIMIT 1")
        .query(Users::user)
        .optional();
  }

  /** Changes a user's own password and ends the user's other sessions. */
  public void changePassword(String id, String present, String next) {
    User user = find(id);
    if (signIn(user.name(), present).isEmpty()) {
      throw RequestException.malformed("current: wrong password.");
    }
    setPassword(user, next);
    events.publishEvent(new PasswordChange(user));
  }

  boolean hasAdministratorWithPassword() {
    return jdbc.sql(
                "SELECT COUNT(*) FROM person WHERE role = 'ADMINISTRATOR' AND enabled = TRUE AND"
                    + " password_hash IS NOT NULL")
            .query(Integer.class)
            .single()
        > 0;
  }

  long count() {
    return jdbc.sql("SELECT COUNT(*) FROM person").query(Long.class).single();
  }

  List<User> list(PageRequest page) {
    return jdbc.sql(COLUMNS + "ORDER BY name LIMIT ? OFFSET ?")
        .params(page.getPageSize(), page.getOffset())
        .query(Users::user)
        .list();
  }

  /** Creates a user with a generated password. */
  WithPassword create(String name, Role role) {
    String password = passwords.generate();
    return new WithPassword(insert(name, role, passwords.hash(password)), password);
  }

  /** Creates a user who can only sign in with the launcher's links. */
  User createWithoutPassword(String name, Role role) {
    return insert(name, role, null);
  }

  private User insert(String name, Role role, @Nullable String hash) {
    String known = normal(name);
    if (!NAME.matcher(known).matches()) {
      throw RequestException.malformed(
          "name: must be 1 to 60 letters, digits, '.', '_', '@' or '-', and begin with a letter or"
              + " digit.");
    }
    String id = UUID.randomUUID().toString();
    try {
      jdbc.sql(
              "INSERT INTO person (id, name, role, password_hash, enabled, created)"
                  + " VALUES (?, ?, ?, ?, TRUE, ?)")
          .params(id, known, role.name(), hash, now())
          .update();
    } catch (DuplicateKeyException e) {
      throw RequestException.conflict("There is a user named " + known + " already.");
    }
    return find(id);
  }

  /** Generates a new password and ends the user's sessions. */
  WithPassword resetPassword(String id) {
    User user = find(id);
    String password = passwords.generate();
    setPassword(user, password);
    events.publishEvent(new PasswordChange(user));
    return new WithPassword(user, password);
  }

  /** Changes a user's role and state; ends the user's sessions, so that it takes effect at once. */
  User change(String id, @Nullable Role role, @Nullable Boolean enabled) {
    User changed =
        keepingAnAdministrator(
            id,
            user ->
                jdbc.sql("UPDATE person SET role = ?, enabled = ? WHERE id = ?")
                    .params(
                        (role == null ? user.role() : role).name(),
                        enabled == null ? user.enabled() : enabled,
                        id)
                    .update());
    endSessions(changed.name());
    return find(id);
  }

  /** Deletes a user and the user's tokens, and ends the user's sessions. */
  void delete(String id) {
    User removed =
        keepingAnAdministrator(
            id, user -> jdbc.sql("DELETE FROM person WHERE id = ?").param(id).update());
    endSessions(removed.name());
  }

  /** Rolls the change back if no enabled administrator would remain. */
  private User keepingAnAdministrator(String id, java.util.function.Consumer<User> change) {
    return java.util.Objects.requireNonNull(
        transaction.execute(
            status -> {
              // Lock all administrators in one order, so that two cannot delete each other.
              jdbc.sql("SELECT id FROM person WHERE role = 'ADMINISTRATOR' ORDER BY id FOR UPDATE")
                  .query(String.class)
                  .list();
              User user = find(id);
              change.accept(user);
              if (firstAdministrator().isEmpty()) {
                throw RequestException.conflict(
                    user.name() + " is the only administrator; create another one first.");
              }
              return user;
            }));
  }

  private void setPassword(User user, String password) {
    jdbc.sql("UPDATE person SET password_hash = ? WHERE id = ?")
        .params(passwords.hash(password), user.id())
        .update();
    endSessions(user.name());
  }

  private void endSessions(String name) {
    sessions.findByPrincipalName(name).keySet().forEach(sessions::deleteById);
  }

  /** A name as it is stored. */
  public static String normal(String name) {
    return name.strip().toLowerCase(Locale.ROOT);
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }

  private static User user(ResultSet row, int index) throws SQLException {
    OffsetDateTime lastSignIn = row.getObject(6, OffsetDateTime.class);
    @Nullable Instant last = lastSignIn == null ? null : lastSignIn.toInstant();
    return new User(
        row.getString(1),
        row.getString(2),
        Role.valueOf(row.getString(3)),
        row.getBoolean(4),
        row.getObject(5, OffsetDateTime.class).toInstant(),
        last);
  }
}
