package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.WebhookReceiver;
import tools.jackson.databind.JsonNode;

/** Webhooks get of a commit what a forge gets, and the groups of differences with it. */
@Tag("slow")
class CommitWebhookStoryTest extends GitStory {
  private final WebhookReceiver receiver = new WebhookReceiver();

  @AfterEach
  void stop() {
    receiver.close();
  }

  private String webhook(String further) {
    return api.post("/api/v1/webhooks", "{\"url\": \"%s\"%s}".formatted(receiver.url(), further))
        .expect(201)
        .json()
        .get("webhook")
        .get("id")
        .asString();
  }

  private List<JsonNode> of(String sha) {
    return receiver.messages().stream()
        .map(WebhookReceiver.Message::json)
        .filter(message -> message.path("commit").asString("").equals(sha))
        .toList();
  }

  private void awaitFinished(String sha) {
    Awaitility.await()
        .atMost(Duration.ofSeconds(60))
        .until(
            () ->
                of(sha).stream()
                    .anyMatch(m -> m.get("event").asString().equals("commit.finished")));
  }

  @Test
  void aCommitIsReportedWithItsGroupsOfDifferences() throws InterruptedException {
    String hook = webhook("");
    String other = webhook(", \"activity\": \"of-others\"");
    String first = repository.commit("One");
    String activity = create("");
    await(activity, first, "DONE");
    awaitFinished(first);
    repository.write(DATA_FILE, "2 3");
    String second = repository.commit("Break two cases");
    fetch(activity);
    await(activity, second, "DONE");
    awaitFinished(second);
    // A further message would come soon.
    Thread.sleep(500);
    assertThat(of(second))
        .extracting(m -> m.get("event").asString())
        .containsExactly("commit.started", "commit.finished");
    JsonNode started = of(second).get(0);
    assertThat(started.get("result").asString()).isEqualTo("pending");
    assertThat(started.has("comment")).isFalse();
    JsonNode finished = of(second).get(1);
    assertThat(finished.get("activity").asString()).isEqualTo("ir-sensor");
    assertThat(finished.get("activityId").asString()).isEqualTo(activity);
    assertThat(finished.get("subject").asString()).isEqualTo("Break two cases");
    assertThat(finished.get("branch").asString()).isEqualTo("main");
    assertThat(finished.has("request")).isFalse();
    assertThat(finished.get("result").asString()).isEqualTo("failure");
    assertThat(finished.get("description").asString())
        .isEqualTo("2 of 55 cases did not pass; 2 differ from " + first.substring(0, 10));
    assertThat(finished.get("url").asString()).endsWith("?tab=commits&commit=" + second);
    assertThat(finished.get("comment").asString())
        .isEqualTo(
            api.get("/api/v1/activities/" + activity + "/git/commits/" + second + "/comment")
                .expect(200)
                .text())
        .contains("- `GetInfraredData`: 53 of 55 passed; 2 of 55 cases differ\n  - `");
    JsonNode model = finished.get("models").get(0);
    assertThat(model.get("model").asString()).isEqualTo("GetInfraredData");
    assertThat(model.get("passed").asInt()).isEqualTo(53);
    assertThat(model.get("differing").asInt()).isEqualTo(2);
    // The build of each commit is reported as well.
    assertThat(receiver.messages().stream().map(m -> m.json().path("build").asString("")))
        .contains(model.get("build").asString());
    JsonNode deliveries = get("/api/v1/webhooks/" + hook + "/deliveries").get("items");
    assertThat(deliveries).hasSize(6);
    assertThat(deliveries)
        .filteredOn(d -> d.has("commit"))
        .hasSize(4)
        .allSatisfy(d -> assertThat(d.has("buildId")).isFalse());
    assertThat(get("/api/v1/webhooks/" + other + "/deliveries").get("items")).isEmpty();
    api.delete("/api/v1/webhooks/" + hook).expect(204);
    api.delete("/api/v1/webhooks/" + other).expect(204);
  }

  @Test
  void eachAttemptSendsTheSameMessageAfterTheFirstOne() {
    String hook = webhook(", \"events\": [\"commit.started\", \"commit.finished\"]");
    String first = repository.commit("One");
    String activity = create("");
    await(activity, first, "DONE");
    awaitFinished(first);
    repository.git("rm", "-q", FOLDER + "/activity.yaml");
    String invalid = repository.commit("Remove the profile");
    receiver.answer(500);
    receiver.answer(204);
    receiver.answer(500);
    fetch(activity);
    await(activity, invalid, "INVALID");
    awaitFinished(invalid);
    Awaitility.await()
        .atMost(Duration.ofSeconds(60))
        .until(
            () ->
                get("/api/v1/webhooks/" + hook + "/deliveries")
                    .get("items")
                    .valueStream()
                    .allMatch(d -> d.get("state").asString().equals("DELIVERED")));
    List<JsonNode> received = of(invalid);
    // The first attempt of each failed, and the end is reported after the start.
    assertThat(received)
        .extracting(m -> m.get("event").asString())
        .containsExactly("commit.started", "commit.started", "commit.finished", "commit.finished");
    assertThat(received.get(received.size() - 1).get("result").asString()).isEqualTo("error");
    assertThat(received.get(received.size() - 1).get("description").asString())
        .contains("holds no activity.yaml");
    for (WebhookReceiver.Message message : receiver.messages()) {
      assertThat(receiver.messages())
          .filteredOn(m -> m.delivery().equals(message.delivery()))
          .allSatisfy(m -> assertThat(m.body()).isEqualTo(message.body()));
    }
    api.delete("/api/v1/webhooks/" + hook).expect(204);
  }
}
