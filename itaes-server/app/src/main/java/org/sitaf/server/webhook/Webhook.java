package org.sitaf.server.webhook;

import java.net.URI;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * A URL that is notified when a build ends.
 *
 * @param activityOrNull name of the activities whose builds are reported; null for all
 */
record Webhook(
    String id, URI url, @Nullable String activityOrNull, Instant created, String createdBy) {
  Optional<String> activity() {
    return Optional.ofNullable(activityOrNull);
  }
}
