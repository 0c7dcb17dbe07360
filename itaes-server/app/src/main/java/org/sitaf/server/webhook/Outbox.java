package org.sitaf.server.webhook;

import java.time.Clock;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;

/**
 * Stores messages to send, in the transaction of what they report, so that no message is lost. A
 * webhook gets one message of an event of a build or commit, even if the event is repeated.
 */
@Component
class Outbox {
  private final JdbcClient jdbc;
  private final Clock clock;

  Outbox(JdbcClient jdbc, Clock clock) {
    this.jdbc = jdbc;
    this.clock = clock;
  }

  void addBuild(Webhook webhook, WebhookEvent event, String buildId, String payload) {
    add(webhook, event, "build_id", buildId, payload);
  }

  /**
   * Adds a message of a commit.
   *
   * @param payload null to compose it when it is sent
   */
  void addCommit(Webhook webhook, WebhookEvent event, String commitId, @Nullable String payload) {
    add(webhook, event, "commit_id", commitId, payload);
  }

  private void add(
      Webhook webhook, WebhookEvent event, String column, String id, @Nullable String payload) {
    boolean known =
        jdbc.sql(
                    "SELECT COUNT(*) FROM webhook_delivery WHERE webhook_id = ? AND event = ? AND "
                        + column
                        + " = ?")
                .params(webhook.id(), event.text(), id)
                .query(Integer.class)
                .single()
            > 0;
    if (!known) {
      OffsetDateTime now = clock.instant().atOffset(ZoneOffset.UTC);
      jdbc.sql(
              "INSERT INTO webhook_delivery (id, webhook_id, event, "
                  + column
                  + ", payload, state, tries, due, created)"
                  + " VALUES (?, ?, ?, ?, ?, 'WAITING', 0, ?, ?)")
          .params(UUID.randomUUID().toString(), webhook.id(), event.text(), id, payload, now, now)
          .update();
    }
  }
}
