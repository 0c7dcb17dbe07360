package org.sitaf.server.access.user;

import java.time.Instant;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Role;

/**
 * A user.
 *
 * @param name in lower case
 * @param enabled whether the user can sign in
 */
public record User(
    String id,
    String name,
    Role role,
    boolean enabled,
    Instant created,
    @Nullable Instant lastSignInOrNull) {
  public User {
    Objects.requireNonNull(id);
    Objects.requireNonNull(name);
    Objects.requireNonNull(role);
    Objects.requireNonNull(created);
  }

  /** Empty if the user never signed in. */
  public Optional<Instant> lastSignIn() {
    return Optional.ofNullable(lastSignInOrNull);
  }

  /** The user as the caller of requests in a session. */
  public Caller caller() {
    return new Caller(name, role, Caller.Kind.PERSON, id);
  }
}
