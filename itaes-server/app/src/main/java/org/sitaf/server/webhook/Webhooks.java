package org.sitaf.server.webhook;

import java.net.URI;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Secret;
import org.sitaf.server.error.RequestException;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;

/** Stores webhooks. */
@Service
class Webhooks {
  private static final String SECRET_PREFIX = "sitaf-hook_";
  private static final String COLUMNS =
      "SELECT id, url, activity, events, created, created_by FROM webhook ";

  private final JdbcClient jdbc;
  private final Target target;
  private final Clock clock;

  Webhooks(JdbcClient jdbc, WebhookSettings settings, Clock clock) {
    this.jdbc = jdbc;
    this.target = new Target(settings);
    this.clock = clock;
  }

  /** A new webhook and its secret, which is shown only once. */
  record WithSecret(Webhook webhook, String secret) {}

  WithSecret create(
      String url, @Nullable String activity, Set<WebhookEvent> events, String createdBy) {
    URI address = target.verify(url);
    String id = UUID.randomUUID().toString();
    String secret = Secret.generate(SECRET_PREFIX);
    jdbc.sql(
            "INSERT INTO webhook (id, url, secret, activity, events, created, created_by)"
                + " VALUES (?, ?, ?, ?, ?, ?, ?)")
        .params(
            id, address.toString(), secret, activity, WebhookEvent.stored(events), now(), createdBy)
        .update();
    return new WithSecret(find(id), secret);
  }

  Webhook find(String id) {
    return jdbc.sql(COLUMNS + "WHERE id = ?")
        .param(id)
        .query(Webhooks::webhook)
        .optional()
        .orElseThrow(() -> RequestException.notFound("webhook", id));
  }

  List<Webhook> list(PageRequest page) {
    return jdbc.sql(COLUMNS + "ORDER BY created DESC, id LIMIT ? OFFSET ?")
        .params(page.getPageSize(), page.getOffset())
        .query(Webhooks::webhook)
        .list();
  }

  long count() {
    return jdbc.sql("SELECT COUNT(*) FROM webhook").query(Long.class).single();
  }

  void delete(String id) {
    find(id);
    jdbc.sql("DELETE FROM webhook WHERE id = ?").param(id).update();
  }

  /** The webhooks that report an event of an activity with this name. */
  List<Webhook> reporting(WebhookEvent event, String activity) {
    return jdbc.sql(COLUMNS).query(Webhooks::webhook).list().stream()
        .filter(webhook -> webhook.reports(event, activity))
        .toList();
  }

  /** Whether there is any webhook; without one, nothing has to be composed. */
  boolean isEmpty() {
    return count() == 0;
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }

  private static Webhook webhook(ResultSet row, int index) throws SQLException {
    Instant created = row.getObject(5, OffsetDateTime.class).toInstant();
    return new Webhook(
        row.getString(1),
        URI.create(row.getString(2)),
        row.getString(3),
        WebhookEvent.read(row.getString(4)),
        created,
        row.getString(6));
  }
}
