package org.sitaf.server.webhook;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import org.sitaf.server.support.WebhookReceiver;
import tools.jackson.databind.JsonNode;

/** Webhooks are called when a build ends, with a signature and with retries. */
@Tag("slow")
class WebhookStoryTest extends ServerTest {
  private final WebhookReceiver receiver = new WebhookReceiver();

  @AfterEach
  void stop() {
    receiver.close();
  }

  @Test
  void deliveryIsSignedAndRetriedUntilConfirmed() {
    receiver.answer(302);
    JsonNode created =
        api.post("/api/v1/webhooks", "{\"url\":\"%s\"}".formatted(receiver.url()))
            .expect(201)
            .json();
    String id = created.get("webhook").get("id").asString();
    String build = api.build(api.suite(api.upload(Activities.zip())));
    api.post("/api/v1/builds/" + build + "/cancel", "").expect(200);
    await().atMost(Duration.ofSeconds(60)).until(() -> delivery(id, "DELIVERED"));
    List<WebhookReceiver.Message> messages = receiver.messages();
    assertThat(messages).hasSize(2).allSatisfy(m -> assertThat(m.path()).isEqualTo("/hook"));
    assertThat(messages).extracting(WebhookReceiver.Message::delivery).doesNotContainNull();
    assertThat(messages.stream().map(WebhookReceiver.Message::delivery).distinct()).hasSize(1);
    assertThat(messages)
        .allSatisfy(m -> assertThat(m.isSignedBy(created.get("secret").asString())).isTrue());
    JsonNode payload = messages.get(0).json();
    assertThat(payload.get("event").asString()).isEqualTo("build.finished");
    assertThat(payload.get("build").asString()).isEqualTo(build);
    assertThat(payload.get("state").asString()).isEqualTo("CANCELLED");
    assertThat(payload.get("model").asString()).isEqualTo(Activities.MODEL);
    api.delete("/api/v1/webhooks/" + id).expect(204);
    api.get("/api/v1/webhooks/" + id + "/deliveries").expect(404);
  }

  @Test
  void suspectBuildHasNotPassed() {
    String id =
        api.post("/api/v1/webhooks", "{\"url\":\"%s\"}".formatted(receiver.url()))
            .expect(201)
            .json()
            .get("webhook")
            .get("id")
            .asString();
    String build = api.build(api.suite(api.upload(Activities.zip())));
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "suspect", "java")) {
      Assignment assignment = agent.nextAssignment();
      agent.submit(
          assignment.getAttempt(),
          FakeAgent.result(agent.download(assignment), List.of(), List.of("a torn line")));
    }
    await().atMost(Duration.ofSeconds(60)).until(() -> delivery(id, "DELIVERED"));
    JsonNode message = receiver.messages().get(0).json();
    assertThat(message.get("build").asString()).isEqualTo(build);
    assertThat(message.get("state").asString()).isEqualTo("DONE");
    assertThat(message.get("counts").get("pass").asInt()).isEqualTo(55);
    assertThat(message.get("passed").asBoolean()).isFalse();
    assertThat(message.get("suspicions").get(0).asString()).isEqualTo("a torn line");
    api.delete("/api/v1/webhooks/" + id).expect(204);
  }

  @Test
  void hostThatIsNotAllowedIsRejected() {
    assertThat(
            api.post("/api/v1/webhooks", "{\"url\":\"http://169.254.169.254/\"}")
                .expect(400)
                .text())
        .contains("sitaf.webhooks.allowed-hosts");
  }

  @Test
  void eventsAreThoseThatWereAskedFor() {
    String body = "{\"url\":\"%s\", \"events\": [%s]}";
    assertThat(api.post("/api/v1/webhooks", body.formatted(receiver.url(), "")).expect(400).text())
        .contains("events: must name at least one event");
    assertThat(
            api.post("/api/v1/webhooks", body.formatted(receiver.url(), "\"build.started\""))
                .expect(400)
                .text())
        .contains("build.started", "build.finished");
    JsonNode created =
        api.post("/api/v1/webhooks", body.formatted(receiver.url(), "\"commit.finished\""))
            .expect(201)
            .json()
            .get("webhook");
    assertThat(created.get("events").toString()).isEqualTo("[\"commit.finished\"]");
    String build = api.build(api.suite(api.upload(Activities.zip())));
    api.post("/api/v1/builds/" + build + "/cancel", "").expect(200);
    String id = created.get("id").asString();
    assertThat(api.get("/api/v1/webhooks/" + id + "/deliveries").json().get("items")).isEmpty();
    api.delete("/api/v1/webhooks/" + id).expect(204);
  }

  private boolean delivery(String id, String state) {
    JsonNode items =
        api.get("/api/v1/webhooks/" + id + "/deliveries").expect(200).json().get("items");
    return items.size() == 1 && items.get(0).get("state").asString().equals(state);
  }
}
