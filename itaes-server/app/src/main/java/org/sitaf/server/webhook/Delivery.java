package org.sitaf.server.webhook;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * What is, or was, to be sent to a webhook.
 *
 * @param tries how often it was tried so far
 * @param due when it is tried next, while it waits
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
  /** What became of it. */
  enum State {
    /** Is tried when it is due. */
    WAITING,
    /** The other side has confirmed it. */
    DELIVERED,
    /** Was tried for too long. */
    GIVEN_UP
  }

  Optional<String> lastAnswer() {
    return Optional.ofNullable(lastAnswerOrNull);
  }
}
