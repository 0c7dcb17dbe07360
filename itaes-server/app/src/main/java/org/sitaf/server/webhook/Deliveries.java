package org.sitaf.server.webhook;

import java.io.IOException;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.storage.DiskSpace;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Service;

/** Sends webhook messages, with retries until the receiver confirms them. */
@Service
class Deliveries {
  private static final Logger log = LoggerFactory.getLogger(Deliveries.class);
  private static final int BATCH_SIZE = 20;
  private static final int MAX_TRIES = 10;
  private static final int MAX_RESPONSE = 400;
  private static final Duration FIRST_DELAY = Duration.ofSeconds(5);

  /** If a server dies while it sends a message, another server sends it after this time. */
  private static final Duration CLAIM = Duration.ofMinutes(1);

  private static final String COLUMNS =
      "SELECT d.id, d.webhook_id, d.event, d.build_id, c.sha, d.state, d.tries, d.due, d.created,"
          + " d.last_answer FROM webhook_delivery d LEFT JOIN git_commit c ON c.id = d.commit_id ";

  /** The end of a commit is reported after its start. */
  private static final String IN_ORDER =
      " AND (d.event <> 'commit.finished' OR NOT EXISTS (SELECT 1 FROM webhook_delivery s"
          + " WHERE s.webhook_id = d.webhook_id AND s.commit_id = d.commit_id"
          + " AND s.event = 'commit.started' AND s.state = 'WAITING'))";

  private final JdbcClient jdbc;
  private final Sender sender;
  private final CommitMessages commits;
  private final DiskSpace disk;
  private final Clock clock;

  Deliveries(JdbcClient jdbc, Sender sender, CommitMessages commits, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.sender = sender;
    this.commits = commits;
    this.disk = disk;
    this.clock = clock;
  }

  private record Message(
      String url, String secret, @Nullable String payload, @Nullable String commitId) {}

  @Scheduled(fixedDelayString = "${sitaf.webhooks.interval:2s}")
  void sendDue() {
    if (!disk.canWrite()) {
      return;
    }
    List<Delivery> due =
        jdbc.sql(
                COLUMNS
                    + "WHERE d.state = 'WAITING' AND d.due <= ?"
                    + IN_ORDER
                    + " ORDER BY d.due LIMIT ?")
            .params(utc(clock.instant()), BATCH_SIZE)
            .query(Deliveries::delivery)
            .list();
    due.stream().filter(this::claim).forEach(this::send);
  }

  List<Delivery> list(String webhookId, PageRequest page) {
    return jdbc.sql(
            COLUMNS + "WHERE d.webhook_id = ? ORDER BY d.created DESC, d.id LIMIT ? OFFSET ?")
        .params(webhookId, page.getPageSize(), page.getOffset())
        .query(Deliveries::delivery)
        .list();
  }

  long count(String webhookId) {
    return jdbc.sql("SELECT COUNT(*) FROM webhook_delivery WHERE webhook_id = ?")
        .param(webhookId)
        .query(Long.class)
        .single();
  }

  /** Claims a delivery, so that only one of several servers sends it. */
  private boolean claim(Delivery delivery) {
    return jdbc.sql(
                "UPDATE webhook_delivery SET tries = tries + 1, due = ?"
                    + " WHERE id = ? AND tries = ? AND state = 'WAITING'")
            .params(utc(clock.instant().plus(CLAIM)), delivery.id(), delivery.tries())
            .update()
        == 1;
  }

  private void send(Delivery delivery) {
    Message message =
        jdbc.sql(
                "SELECT w.url, w.secret, d.payload, d.commit_id FROM webhook_delivery d"
                    + " JOIN webhook w ON w.id = d.webhook_id WHERE d.id = ?")
            .param(delivery.id())
            .query(
                (row, i) ->
                    new Message(
                        row.getString(1), row.getString(2), row.getString(3), row.getString(4)))
            .optional()
            .orElse(null);
    if (message == null) {
      // The webhook was deleted in the meantime.
      return;
    }
    String response;
    boolean confirmed = false;
    try {
      String payload = message.payload() != null ? message.payload() : compose(delivery, message);
      int status = sender.send(message.url(), message.secret(), delivery.id(), payload);
      confirmed = status / 100 == 2;
      response = "HTTP " + status;
    } catch (IOException | RuntimeException e) {
      response = String.valueOf(e.getMessage());
    }
    int tries = delivery.tries() + 1;
    Delivery.State state =
        confirmed
            ? Delivery.State.DELIVERED
            : tries < MAX_TRIES ? Delivery.State.WAITING : Delivery.State.GIVEN_UP;
    if (state == Delivery.State.GIVEN_UP) {
      log.warn(
          "Delivery of webhook {} for {} {} failed; giving up after {} tries",
          delivery.webhookId(),
          delivery.buildIdOrNull() == null ? "commit" : "build",
          delivery.buildIdOrNull() == null ? delivery.commitOrNull() : delivery.buildIdOrNull(),
          tries);
    }
    jdbc.sql("UPDATE webhook_delivery SET state = ?, due = ?, last_answer = ? WHERE id = ?")
        .params(
            state.name(),
            utc(clock.instant().plus(FIRST_DELAY.multipliedBy(1L << Math.min(tries - 1, 12)))),
            response.substring(0, Math.min(response.length(), MAX_RESPONSE)),
            delivery.id())
        .update();
  }

  /** The message is kept, so that each attempt sends the same one. */
  private String compose(Delivery delivery, Message message) {
    String payload = commits.finished(Objects.requireNonNull(message.commitId()));
    jdbc.sql("UPDATE webhook_delivery SET payload = ? WHERE id = ?")
        .params(payload, delivery.id())
        .update();
    return payload;
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  private static Delivery delivery(ResultSet row, int index) throws SQLException {
    return new Delivery(
        row.getString(1),
        row.getString(2),
        WebhookEvent.of(row.getString(3)),
        row.getString(4),
        row.getString(5),
        Delivery.State.valueOf(row.getString(6)),
        row.getInt(7),
        row.getObject(8, OffsetDateTime.class).toInstant(),
        row.getObject(9, OffsetDateTime.class).toInstant(),
        row.getString(10));
  }
}
