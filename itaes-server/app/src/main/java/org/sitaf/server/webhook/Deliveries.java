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
import org.sitaf.server.storage.DiskSpace;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Service;

/** Sends what is to be sent, again and again until the other side has confirmed it. */
@Service
class Deliveries {
  private static final Logger log = LoggerFactory.getLogger(Deliveries.class);
  private static final int AT_ONCE = 20;
  private static final int MOST_TRIES = 10;
  private static final int LONGEST_ANSWER = 400;
  private static final Duration FIRST_PAUSE = Duration.ofSeconds(5);

  /** Another server takes over what one that died was about to send. */
  private static final Duration CLAIM = Duration.ofMinutes(1);

  private static final String COLUMNS =
      "SELECT id, webhook_id, build_id, state, tries, due, created, last_answer"
          + " FROM webhook_delivery ";

  private final JdbcClient jdbc;
  private final Sender sender;
  private final DiskSpace disk;
  private final Clock clock;

  Deliveries(JdbcClient jdbc, Sender sender, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.sender = sender;
    this.disk = disk;
    this.clock = clock;
  }

  private record Message(String url, String secret, String payload) {}

  @Scheduled(fixedDelayString = "${sitaf.webhooks.interval:2s}")
  void sendDue() {
    if (!disk.canWrite()) {
      return;
    }
    List<Delivery> due =
        jdbc.sql(COLUMNS + "WHERE state = 'WAITING' AND due <= ? ORDER BY due LIMIT ?")
            .params(utc(clock.instant()), AT_ONCE)
            .query(Deliveries::delivery)
            .list();
    due.stream().filter(this::claim).forEach(this::send);
  }

  List<Delivery> list(String webhookId, PageRequest page) {
    return jdbc.sql(COLUMNS + "WHERE webhook_id = ? ORDER BY created DESC, id LIMIT ? OFFSET ?")
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

  /** Of several servers one gets it. */
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
                "SELECT w.url, w.secret, d.payload FROM webhook_delivery d"
                    + " JOIN webhook w ON w.id = d.webhook_id WHERE d.id = ?")
            .param(delivery.id())
            .query((row, i) -> new Message(row.getString(1), row.getString(2), row.getString(3)))
            .optional()
            .orElse(null);
    if (message == null) {
      // The webhook was deleted meanwhile.
      return;
    }
    String answer;
    boolean confirmed = false;
    try {
      int status = sender.send(message.url(), message.secret(), delivery.id(), message.payload());
      confirmed = status / 100 == 2;
      answer = "HTTP " + status;
    } catch (IOException | RuntimeException e) {
      answer = String.valueOf(e.getMessage());
    }
    int tries = delivery.tries() + 1;
    Delivery.State state =
        confirmed
            ? Delivery.State.DELIVERED
            : tries < MOST_TRIES ? Delivery.State.WAITING : Delivery.State.GIVEN_UP;
    if (state == Delivery.State.GIVEN_UP) {
      log.warn("Webhook {} was given up for build {}", delivery.webhookId(), delivery.buildId());
    }
    jdbc.sql("UPDATE webhook_delivery SET state = ?, due = ?, last_answer = ? WHERE id = ?")
        .params(
            state.name(),
            utc(clock.instant().plus(FIRST_PAUSE.multipliedBy(1L << Math.min(tries - 1, 12)))),
            answer.substring(0, Math.min(answer.length(), LONGEST_ANSWER)),
            delivery.id())
        .update();
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  private static Delivery delivery(ResultSet row, int index) throws SQLException {
    return new Delivery(
        row.getString(1),
        row.getString(2),
        row.getString(3),
        Delivery.State.valueOf(row.getString(4)),
        row.getInt(5),
        row.getObject(6, OffsetDateTime.class).toInstant(),
        row.getObject(7, OffsetDateTime.class).toInstant(),
        row.getString(8));
  }
}
