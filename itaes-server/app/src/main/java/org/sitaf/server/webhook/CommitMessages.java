package org.sitaf.server.webhook;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sitaf.server.git.commit.CommitEvent;
import org.sitaf.server.git.forge.CommitReport;
import org.sitaf.server.git.forge.CommitReports;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Component;
import tools.jackson.databind.json.JsonMapper;

/**
 * Reports commits to webhooks, as forges get them: a first message and exactly one final one, whose
 * comment has the groups of differences.
 */
@Component
class CommitMessages {
  private final Webhooks webhooks;
  private final Outbox outbox;
  private final CommitReports reports;
  private final JsonMapper json;

  CommitMessages(Webhooks webhooks, Outbox outbox, CommitReports reports, JsonMapper json) {
    this.webhooks = webhooks;
    this.outbox = outbox;
    this.reports = reports;
    this.json = json;
  }

  /** Runs in the transaction that changes the commit. */
  @EventListener
  void on(CommitEvent event) {
    if (webhooks.isEmpty()) {
      return;
    }
    String id = event.commitId();
    Optional<CommitReport> found = reports.pending(id);
    if (found.isEmpty()) {
      return;
    }
    CommitReport report = found.get();
    String started = json.writeValueAsString(payload(WebhookEvent.COMMIT_STARTED, report));
    webhooks
        .reporting(WebhookEvent.COMMIT_STARTED, report.activity())
        .forEach(webhook -> outbox.addCommit(webhook, WebhookEvent.COMMIT_STARTED, id, started));
    if (event instanceof CommitEvent.Ended) {
      webhooks
          .reporting(WebhookEvent.COMMIT_FINISHED, report.activity())
          .forEach(webhook -> outbox.addCommit(webhook, WebhookEvent.COMMIT_FINISHED, id, null));
    }
  }

  /** The message of a commit that has its final status. */
  String finished(String commitId) {
    return json.writeValueAsString(
        payload(WebhookEvent.COMMIT_FINISHED, reports.finished(commitId)));
  }

  private static Map<String, Object> payload(WebhookEvent event, CommitReport report) {
    Map<String, Object> payload = new LinkedHashMap<>();
    payload.put("event", event.text());
    payload.put("activity", report.activity());
    payload.put("activityId", report.activityId());
    payload.put("commit", report.sha());
    payload.put("subject", report.subject());
    payload.put("author", report.author());
    payload.put("branch", report.branch());
    report.request().ifPresent(number -> payload.put("request", number));
    payload.put("result", report.result());
    payload.put("description", report.description());
    payload.put("url", report.url());
    report
        .details()
        .ifPresent(
            details -> {
              payload.put("models", details.models());
              payload.put("comment", details.comment());
            });
    return payload;
  }
}
