package org.sitaf.server.webhook;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The delivery of a message to a webhook.
 *
 * @param tries number of tries so far
 * @param due time of the next try, if {@link State#WAITING}
 */
record Delivery(
    String id,
    String webhookId,
    String buildId,
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
