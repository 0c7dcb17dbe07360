package org.sitaf.server.access.token;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Role;

/**
 * A token of a person. Its secret is known to its holder only.
 *
 * @param role what it may do at most; never more than its owner may at that time
 * @param expires from then on it is refused
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
  /** Absent for one that was never used. */
  public Optional<Instant> lastUsed() {
    return Optional.ofNullable(lastUsedOrNull);
  }
}
