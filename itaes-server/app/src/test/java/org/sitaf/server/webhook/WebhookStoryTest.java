package org.sitaf.server.webhook;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Webhooks are called when a build ends, with a signature and with retries. */
@Tag("slow")
class WebhookStoryTest extends ServerTest {
  private final Queue<Received> received = new ConcurrentLinkedQueue<>();
  private final Queue<Integer> answers = new ConcurrentLinkedQueue<>();
  private HttpServer receiver;

  private record Received(String path, String delivery, String signature, String body) {}

  @BeforeEach
  void listen() throws IOException {
    receiver = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    receiver.createContext(
        "/",
        exchange -> {
          String body =
              new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8);
          received.add(
              new Received(
                  exchange.getRequestURI().getPath(),
                  exchange.getRequestHeaders().getFirst("Sitaf-Delivery"),
                  exchange.getRequestHeaders().getFirst("Sitaf-Signature"),
                  body));
          Integer status = answers.poll();
          exchange.getResponseHeaders().set("Location", "/elsewhere");
          exchange.sendResponseHeaders(status == null ? 204 : status, -1);
          exchange.close();
        });
    receiver.start();
  }

  @AfterEach
  void stop() {
    receiver.stop(0);
  }

  @Test
  void deliveryIsSignedAndRetriedUntilConfirmed() {
    answers.add(302);
    JsonNode created =
        api.post(
                "/api/v1/webhooks",
                "{\"url\":\"http://localhost:%d/hook\"}".formatted(receiver.getAddress().getPort()))
            .expect(201)
            .json();
    String id = created.get("webhook").get("id").asString();
    String build = api.build(api.suite(api.upload(Activities.zip())));
    api.post("/api/v1/builds/" + build + "/cancel", "").expect(200);
    await().atMost(Duration.ofSeconds(60)).until(() -> delivery(id, "DELIVERED"));
    assertThat(received).hasSize(2).allSatisfy(r -> assertThat(r.path()).isEqualTo("/hook"));
    assertThat(received).extracting(Received::delivery).doesNotContainNull();
    assertThat(received.stream().map(Received::delivery).distinct()).hasSize(1);
    assertThat(received)
        .allSatisfy(
            r -> assertThat(isSignedBy(created.get("secret").asString(), r)).as(r.body()).isTrue());
    JsonNode payload = JsonMapper.shared().readTree(received.element().body());
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
        api.post(
                "/api/v1/webhooks",
                "{\"url\":\"http://localhost:%d/hook\"}".formatted(receiver.getAddress().getPort()))
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
    JsonNode message = JsonMapper.shared().readTree(received.element().body());
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

  private boolean delivery(String id, String state) {
    JsonNode items =
        api.get("/api/v1/webhooks/" + id + "/deliveries").expect(200).json().get("items");
    return items.size() == 1 && items.get(0).get("state").asString().equals(state);
  }

  private static boolean isSignedBy(String secret, Received message) {
    String[] parts = message.signature().split("[=,]");
    return Sender.hmac(secret, parts[1] + "." + message.body()).equals(parts[3]);
  }
}
