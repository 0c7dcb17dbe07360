package org.sitaf.server.webhook;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The delivery of a message to a webhook.
 *
 * @param buildIdOrNull the build that it reports; null if it reports a commit
 * @param commitOrNull id of the commit in Git that it reports; null if it reports a build
 * @param tries number of tries so far
 * @param due time of the next try, if {@link State#WAITING}
 */
record Delivery(
    String id,
    String webhookId,
    WebhookEvent event,
    @Nullable String buildIdOrNull,
    @Nullable String commitOrNull,
    State state,
    int tries,
    Instant due,
    Instant created,
    @Nullable String lastAnswerOrNull) {
  enum State {
    /** Will be sent when it is due. */
    WAITING,
    /** The receiver confirmed it. */
    DELIVERED,
    /** All tries failed. */
    GIVEN_UP
  }

  Optional<String> lastAnswer() {
    return Optional.ofNullable(lastAnswerOrNull);
  }
}
