package org.sitaf.server.access.token;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Role;

/**
 * An API token of a user. Its secret is stored as a hash only.
 *
 * @param role upper limit of its permissions; the owner's current role limits them, too
 */
public record ApiToken(
    String id,
    String name,
    String ownerId,
    String owner,
    Role role,
    Instant created,
    Instant expires,
    @Nullable Instant lastUsedOrNull) {
  /** Empty if the token was never used. */
  public Optional<Instant> lastUsed() {
    return Optional.ofNullable(lastUsedOrNull);
  }
}
