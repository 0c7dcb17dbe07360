package org.sitaf.server.webhook;

import java.net.URI;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Secret;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.build.BuildKind;
import org.sitaf.server.build.Builds;
import org.sitaf.server.error.RequestException;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;
import org.springframework.transaction.event.TransactionPhase;
import org.springframework.transaction.event.TransactionalEventListener;
import tools.jackson.databind.json.JsonMapper;

/** Stores webhooks and creates deliveries when builds end. */
@Service
class Webhooks {
  private static final String SECRET_PREFIX = "sitaf-hook_";
  private static final String COLUMNS =
      "SELECT id, url, activity, created, created_by FROM webhook ";

  private final JdbcClient jdbc;
  private final Builds builds;
  private final Target target;
  private final JsonMapper json;
  private final Clock clock;

  Webhooks(JdbcClient jdbc, Builds builds, WebhookSettings settings, JsonMapper json, Clock clock) {
    this.jdbc = jdbc;
    this.builds = builds;
    this.target = new Target(settings);
    this.json = json;
    this.clock = clock;
  }

  /** A new webhook and its secret, which is shown only once. */
  record WithSecret(Webhook webhook, String secret) {}

  WithSecret create(String url, @Nullable String activity, String createdBy) {
    URI address = target.verify(url);
    String id = UUID.randomUUID().toString();
    String secret = Secret.generate(SECRET_PREFIX);
    jdbc.sql(
            "INSERT INTO webhook (id, url, secret, activity, created, created_by)"
                + " VALUES (?, ?, ?, ?, ?, ?)")
        .params(id, address.toString(), secret, activity, now(), createdBy)
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

  /** Runs in the transaction that ends the build, so that no delivery is lost. */
  @TransactionalEventListener(phase = TransactionPhase.BEFORE_COMMIT)
  void on(BuildEvent.Changed changed) {
    if (!changed.state().isOver()) {
      return;
    }
    List<Webhook> all = jdbc.sql(COLUMNS).query(Webhooks::webhook).list();
    if (all.isEmpty()) {
      return;
    }
    if (builds.inspect(changed.buildId(), Build::kind) != BuildKind.TEST) {
      return;
    }
    Map<String, Object> payload = builds.inspect(changed.buildId(), Webhooks::payload);
    for (Webhook webhook : all) {
      boolean matches =
          webhook.activity().map(name -> name.equals(payload.get("activity"))).orElse(true);
      if (matches) {
        enqueue(webhook, changed.buildId(), json.writeValueAsString(payload));
      }
    }
  }

  private void enqueue(Webhook webhook, String buildId, String payload) {
    boolean known =
        jdbc.sql("SELECT COUNT(*) FROM webhook_delivery WHERE webhook_id = ? AND build_id = ?")
                .params(webhook.id(), buildId)
                .query(Integer.class)
                .single()
            > 0;
    if (!known) {
      jdbc.sql(
              "INSERT INTO webhook_delivery (id, webhook_id, build_id, payload, state, tries, due,"
                  + " created) VALUES (?, ?, ?, ?, 'WAITING', 0, ?, ?)")
          .params(UUID.randomUUID().toString(), webhook.id(), buildId, payload, now(), now())
          .update();
    }
  }

  private static Map<String, Object> payload(Build build) {
    Map<String, Object> payload = new LinkedHashMap<>();
    payload.put("event", "build.finished");
    payload.put("build", build.id());
    payload.put("activity", build.activityName());
    payload.put("model", build.model());
    payload.put("state", build.state().name());
    build.finished().ifPresent(at -> payload.put("finished", at.toString()));
    build.counts().ifPresent(counts -> payload.put("counts", counts));
    if (!build.suspicions().isEmpty()) {
      payload.put("suspicions", build.suspicions());
    }
    build
        .counts()
        .ifPresent(
            counts ->
                payload.put(
                    "passed",
                    build.suspicions().isEmpty() && counts.pass().equals(counts.total())));
    build.failure().ifPresent(failure -> payload.put("failure", failure.message()));
    return payload;
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }

  private static Webhook webhook(ResultSet row, int index) throws SQLException {
    Instant created = row.getObject(4, OffsetDateTime.class).toInstant();
    return new Webhook(
        row.getString(1),
        URI.create(row.getString(2)),
        row.getString(3),
        created,
        row.getString(5));
  }
}
