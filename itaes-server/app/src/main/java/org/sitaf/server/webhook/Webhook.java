package org.sitaf.server.webhook;

import java.net.URI;
import java.time.Instant;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * A URL that is notified of events.
 *
 * @param activityOrNull name of the activities whose builds and commits are reported; null for all
 * @param events what is reported
 */
record Webhook(
    String id,
    URI url,
    @Nullable String activityOrNull,
    Set<WebhookEvent> events,
    Instant created,
    String createdBy) {
  Optional<String> activity() {
    return Optional.ofNullable(activityOrNull);
  }

  /** Whether it reports an event of an activity with this name. */
  boolean reports(WebhookEvent event, String activityName) {
    return events.contains(event)
        && (activityOrNull == null || activityOrNull.equals(activityName));
  }
}
