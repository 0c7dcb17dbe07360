package org.sitaf.server.access.session;

import java.time.Clock;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.Optional;
import org.sitaf.server.access.Secret;
import org.sitaf.server.access.user.User;
import org.sitaf.server.access.user.Users;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;

/** Links that sign in a user, each of which can be used once. */
@Service
class SignInLinks {
  private static final Duration VALID = Duration.ofHours(24);

  private final JdbcClient jdbc;
  private final Users users;
  private final Clock clock;

  SignInLinks(JdbcClient jdbc, Users users, Clock clock) {
    this.jdbc = jdbc;
    this.users = users;
    this.clock = clock;
  }

  /** Creates the code of a link for a user. */
  String create(String personId) {
    String code = Secret.generate("");
    jdbc.sql("DELETE FROM sign_in_link WHERE expires < ?").param(now()).update();
    jdbc.sql("INSERT INTO sign_in_link (hash, person_id, expires) VALUES (?, ?, ?)")
        .params(Secret.hash(code), personId, now().plus(VALID))
        .update();
    return code;
  }

  /** Consumes a link and signs its user in; empty if the link is invalid, used or expired. */
  Optional<User> use(String code) {
    String hash = Secret.hash(code);
    Optional<String> personId =
        jdbc.sql("SELECT person_id FROM sign_in_link WHERE hash = ? AND expires > ?")
            .params(hash, now())
            .query(String.class)
            .optional();
    // Of two concurrent requests only the one that deletes the row succeeds.
    boolean first = jdbc.sql("DELETE FROM sign_in_link WHERE hash = ?").param(hash).update() == 1;
    return personId.filter(id -> first).map(users::find).filter(User::enabled).map(users::signedIn);
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }
}
