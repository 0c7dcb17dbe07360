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
import org.sitaf.server.refusal.Refusal;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.session.FindByIndexNameSessionRepository;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** The people who may sign in. There is always an administrator among them, once there was one. */
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

  /** Somebody has another password than before. */
  record PasswordChange(User user) {}

  /** A person, and the password that was made for them: to be shown once, and stored nowhere. */
  public record WithPassword(User user, String password) {}

  /**
   * The person of this name and password, who thereby signs in.
   *
   * @return empty when there is none, or they may not
   */
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

  /** Notes that a person has signed in, in whichever way. */
  public User signedIn(User user) {
    jdbc.sql("UPDATE person SET last_sign_in = ? WHERE id = ?").params(now(), user.id()).update();
    return find(user.id());
  }

  /** The person of this name. */
  public Optional<User> byName(String name) {
    return jdbc.sql(COLUMNS + "WHERE name = ?").param(normal(name)).query(Users::user).optional();
  }

  /**
   * The person of an id.
   *
   * @throws Refusal when there is none
   */
  public User find(String id) {
    return jdbc.sql(COLUMNS + "WHERE id = ?")
        .param(id)
        .query(Users::user)
        .optional()
        .orElseThrow(() -> Refusal.notFound("user", id));
  }

  /** The administrator who was there first and may sign in. */
  public Optional<User> firstAdministrator() {
    return jdbc.sql(
            COLUMNS
                + "WHERE role = 'ADMINISTRATOR' AND enabled = TRUE ORDER BY created, id LIMIT 1")
        .query(Users::user)
        .optional();
  }

  /** A person changes their own password; the other sessions of theirs end. */
  public void changePassword(String id, String present, String next) {
    User user = find(id);
    if (signIn(user.name(), present).isEmpty()) {
      throw Refusal.malformed("current: is not your password.");
    }
    setPassword(user, next);
    events.publishEvent(new PasswordChange(user));
  }

  boolean anAdministratorHasAPassword() {
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

  /** Lets somebody in, with a password that is made here. */
  WithPassword create(String name, Role role) {
    String password = passwords.fresh();
    return new WithPassword(insert(name, role, passwords.hash(password)), password);
  }

  /** One who signs in by links of the launcher only, until they are given a password. */
  User createWithoutPassword(String name, Role role) {
    return insert(name, role, null);
  }

  private User insert(String name, Role role, @Nullable String hash) {
    String known = normal(name);
    if (!NAME.matcher(known).matches()) {
      throw Refusal.malformed(
          "name: 1 to 60 letters, digits, '.', '_', '@', '-'; begins with a letter or digit.");
    }
    String id = UUID.randomUUID().toString();
    try {
      jdbc.sql(
              "INSERT INTO person (id, name, role, password_hash, enabled, created)"
                  + " VALUES (?, ?, ?, ?, TRUE, ?)")
          .params(id, known, role.name(), hash, now())
          .update();
    } catch (DuplicateKeyException e) {
      throw Refusal.conflict("There is a user of the name " + known + " already.");
    }
    return find(id);
  }

  /** Gives a person a new password, which is made here; their sessions end. */
  WithPassword resetPassword(String id) {
    User user = find(id);
    String password = passwords.fresh();
    setPassword(user, password);
    events.publishEvent(new PasswordChange(user));
    return new WithPassword(user, password);
  }

  /** Changes what a person may; their sessions end, so that it holds at once. */
  User change(String id, @Nullable Role role, @Nullable Boolean enabled) {
    User changed =
        guarded(
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

  /** Removes a person with their tokens; their sessions end. */
  void delete(String id) {
    User removed =
        guarded(id, user -> jdbc.sql("DELETE FROM person WHERE id = ?").param(id).update());
    endSessions(removed.name());
  }

  /** Refuses a change that would leave nobody who can let people in. */
  private User guarded(String id, java.util.function.Consumer<User> change) {
    return java.util.Objects.requireNonNull(
        transaction.execute(
            status -> {
              // Locks all of them, in one order: two administrators must not remove each other.
              jdbc.sql("SELECT id FROM person WHERE role = 'ADMINISTRATOR' ORDER BY id FOR UPDATE")
                  .query(String.class)
                  .list();
              User user = find(id);
              change.accept(user);
              if (firstAdministrator().isEmpty()) {
                throw Refusal.conflict(
                    user.name() + " is the only administrator; make another one first.");
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

  /** A name as it is stored, however it was typed. */
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
