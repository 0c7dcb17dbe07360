package org.sitaf.server.webhook;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.build.BuildKind;
import org.sitaf.server.build.Builds;
import org.springframework.stereotype.Component;
import org.springframework.transaction.event.TransactionPhase;
import org.springframework.transaction.event.TransactionalEventListener;
import tools.jackson.databind.json.JsonMapper;

/** Reports builds to webhooks. */
@Component
class BuildMessages {
  private final Webhooks webhooks;
  private final Outbox outbox;
  private final Builds builds;
  private final JsonMapper json;

  BuildMessages(Webhooks webhooks, Outbox outbox, Builds builds, JsonMapper json) {
    this.webhooks = webhooks;
    this.outbox = outbox;
    this.builds = builds;
    this.json = json;
  }

  /** Runs in the transaction that ends the build. */
  @TransactionalEventListener(phase = TransactionPhase.BEFORE_COMMIT)
  void on(BuildEvent.Changed changed) {
    if (!changed.state().isOver()
        || webhooks.isEmpty()
        || builds.inspect(changed.buildId(), Build::kind) != BuildKind.TEST) {
      return;
    }
    List<Webhook> reporting =
        webhooks.reporting(
            WebhookEvent.BUILD_FINISHED, builds.inspect(changed.buildId(), Build::activityName));
    if (reporting.isEmpty()) {
      return;
    }
    String payload =
        json.writeValueAsString(builds.inspect(changed.buildId(), BuildMessages::payload));
    reporting.forEach(
        webhook ->
            outbox.addBuild(webhook, WebhookEvent.BUILD_FINISHED, changed.buildId(), payload));
  }

  private static Map<String, Object> payload(Build build) {
    Map<String, Object> payload = new LinkedHashMap<>();
    payload.put("event", WebhookEvent.BUILD_FINISHED.text());
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
}
