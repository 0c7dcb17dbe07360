package org.sitaf.server.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.http.HttpRequest.BodyPublishers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.UUID;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import org.springframework.test.annotation.DirtiesContext;
import org.springframework.test.context.TestPropertySource;
import tools.jackson.databind.JsonNode;

/**
 * Limits for requests and stored data do not affect other users. Each test uses its own client
 * addresses, as behind a proxy.
 */
@DirtiesContext
@TestPropertySource(
    properties = {
      "sitaf.trusted-proxies=127.0.0.0/8,::1",
      ServerTest.OWN_SCHEDULER + "limits",
      "sitaf.limits.body-time=2s",
      "sitaf.limits.sign-in-body-time=2s",
      "sitaf.limits.quota=1MB",
      "sitaf.limits.activities=3",
      "sitaf.limits.suites=2",
      "sitaf.limits.open-builds=2"
    })
class LimitsTest extends ServerTest {
  private static final int SOME_BYTES = 700_000;
  private final String name = "ann-" + UUID.randomUUID().toString().substring(0, 8);

  @Test
  void slowSignInsDoNotBlockOthers() throws IOException {
    List<Socket> slow = new ArrayList<>();
    try {
      for (int i = 0; i < 250; i++) {
        slow.add(
            begin(
                "POST /api/v1/session",
                "X-Forwarded-For: 198.51.100." + i % 50 + "\r\nContent-Type: application/json",
                64,
                "{"));
      }
      for (int i = 0; i < 20; i++) {
        api.get("/api/v1/builds").expect(200);
      }
      for (Socket socket : slow) {
        assertThat(statusOf(socket)).isIn(403, 408, 503);
      }
      String person = user("VIEWER").get("password").asString();
      assertThat(signIn("203.0.113.77", name, person).status()).isEqualTo(200);
    } finally {
      for (Socket socket : slow) {
        socket.close();
      }
    }
  }

  @Test
  void slowBodyTimesOut() throws Exception {
    try (Socket socket =
        begin(
            "POST /api/v1/activities",
            "Authorization: Bearer " + TOKEN + "\r\nContent-Type: application/zip",
            1000,
            "PK")) {
      Thread slowClient =
          new Thread(
              () -> {
                try {
                  for (int i = 0; i < 60; i++) {
                    Thread.sleep(200);
                    socket.getOutputStream().write('x');
                  }
                } catch (IOException | InterruptedException e) {
                  // Expected: the server closed the connection.
                  return;
                }
              });
      slowClient.start();
      assertThat(statusOf(socket)).isEqualTo(408);
      slowClient.interrupt();
      slowClient.join();
    }
  }

  @Test
  void incompleteBodyIsABadRequest() throws IOException {
    for (String request :
        List.of(
            "POST /api/v1/activities@application/zip",
            "POST /api/v1/activity-checks@application/zip",
            "POST /api/v1/activities/x/files@application/zip",
            "POST /api/v1/activity-proposals?name=x@application/zip",
            "POST /api/v1/builds@application/json",
            "PUT /api/v1/activities/x/models/y@application/xml")) {
      String[] parts = request.split("@", -1);
      try (Socket socket =
          begin(
              parts[0],
              "Authorization: Bearer " + TOKEN + "\r\nIf-Match: *\r\nContent-Type: " + parts[1],
              1000,
              "{")) {
        socket.shutdownOutput();
        assertThat(statusOf(socket)).as(request).isIn(400, 404);
      }
    }
  }

  @Test
  void failedSignInsBehindAProxyDoNotLockOutKnownUsers() {
    String address = "203.0.113.5";
    String password = user("VIEWER").get("password").asString();
    assertThat(signIn(address, name, password).status()).isEqualTo(200);
    int throttled = 0;
    for (int i = 0; i < 60; i++) {
      throttled += signIn(address, "guess-" + i, "a wrong password").status() == 429 ? 1 : 0;
    }
    assertThat(throttled).isPositive();
    assertThat(signIn(address, name, password).status()).isEqualTo(200);
    assertThat(signIn("203.0.113.6", "somebody", "a wrong password").status()).isEqualTo(401);
  }

  @Test
  void failedSignInsFromManyAddressesDoNotLockOutKnownUsers() {
    String password = user("VIEWER").get("password").asString();
    assertThat(signIn("203.0.113.9", name, password).status()).isEqualTo(200);
    List<Integer> answers = new ArrayList<>();
    for (int i = 1; i <= 40; i++) {
      answers.add(signIn("2001:db8:" + i + "::1", name, "a wrong password").status());
    }
    assertThat(answers).contains(401, 429);
    assertThat(signIn("203.0.113.9", name, password).status()).isEqualTo(200);
    Api.Answer elsewhere = signIn("203.0.113.10", name, password);
    assertThat(elsewhere.status()).isIn(200, 429);
    if (elsewhere.status() == 429) {
      assertThat(Integer.parseInt(elsewhere.headers().firstValue("Retry-After").orElseThrow()))
          .isBetween(1, 60);
    }
  }

  @Test
  void clientAddressAndSchemeAreTakenFromTheProxy() {
    String password = user("VIEWER").get("password").asString();
    Api.Answer answer = signIn("203.0.113.20", name, password);
    assertThat(answer.headers().allValues("Set-Cookie"))
        .filteredOn(cookie -> cookie.startsWith("SITAF_SESSION="))
        .singleElement()
        .asString()
        .contains("Secure");
    JsonNode events = api.get("/api/v1/audit?actor=" + name).expect(200).json().get("items");
    assertThat(events.get(0).get("address").asString()).isEqualTo("203.0.113.20");
  }

  @Test
  void rejectionsAreSummarizedInTheAuditLog() {
    Instant begun = Instant.now();
    for (int i = 0; i < 100; i++) {
      signIn("203.0.113.30", "nobody-" + i, "a wrong password");
    }
    long minutes = Duration.between(begun, Instant.now()).toMinutes() + 1;
    long kept =
        api.get("/api/v1/audit?action=signIn&actor=-&size=500")
            .expect(200)
            .json()
            .get("items")
            .valueStream()
            .filter(event -> event.get("address").asString().equals("203.0.113.30"))
            .count();
    // 30 events in each minute, and what the minute before left out.
    assertThat(kept).isBetween(1L, 31 * minutes);
  }

  @Test
  void quotaIsEnforced() {
    JsonNode created = user("TESTER");
    Api own = new Api(httpPort(), token(created));
    byte[] first = activityWith(1);
    own.upload(first);
    own.upload(first);
    Api.Answer rejected =
        own.post("/api/v1/activities", "application/zip", activityWith(2)).expect(413);
    assertThat(rejected.text()).contains("MiB");
    JsonNode usage = own.get("/api/v1/session/usage").expect(200).json();
    assertThat(usage.get("bytes").asLong()).isBetween((long) SOME_BYTES, 1L << 20);
    assertThat(usage.get("maxBytes").asLong()).isEqualTo(1L << 20);
    assertThat(usage.get("activities").asInt()).isEqualTo(2);

    String path = "/api/v1/users/" + created.get("user").get("id").asString();
    api.put(
            path + "/quota",
            "application/json",
            "{\"mib\":-1}".getBytes(StandardCharsets.UTF_8),
            null)
        .expect(400);
    api.put(
            path + "/quota",
            "application/json",
            "{\"mib\":50}".getBytes(StandardCharsets.UTF_8),
            null)
        .expect(200);
    String id = own.upload(activityWith(2));
    assertThat(own.post("/api/v1/activities", "application/zip", first).expect(409).text())
        .contains("You have 3 of at most 3 activities");
    assertThat(api.get(path + "/usage").expect(200).json().get("activities").asInt()).isEqualTo(3);
    own.delete("/api/v1/activities/" + id).expect(204);
    String again = own.upload(first);
    String suite = own.suite(again);
    own.suite(again);
    own.post("/api/v1/activities/" + again + "/models/" + Activities.MODEL + "/suites", "{}")
        .expect(409);
    own.build(suite);
    own.build(suite);
    own.post("/api/v1/builds", "{\"suiteId\":\"" + suite + "\"}").expect(409);
    api.get("/api/v1/session/usage").expect(403);
  }

  @Test
  void largeResultIsUploadedInChunks() throws Exception {
    api.build(api.suite(api.upload(Activities.zip())));
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "chunks-" + name, "java")) {
      Assignment assignment = agent.nextAssignment();
      byte[] document = FakeAgent.result(agent.download(assignment), List.of());
      byte[] large = java.util.Arrays.copyOf(document, document.length + (6 << 20));
      java.util.Arrays.fill(large, document.length, large.length, (byte) '\n');
      assertThat(agent.submitInChunks(assignment.getAttempt(), large, 1 << 20)).isTrue();
      String build = assignment.getAttempt().getBuildId();
      assertThat(api.get("/api/v1/builds/" + build).json().get("state").asString())
          .isEqualTo("DONE");
    }
  }

  private byte[] activityWith(long seed) {
    byte[] noise = new byte[SOME_BYTES];
    new Random(seed).nextBytes(noise);
    Map<String, byte[]> files = Activities.files();
    files.put("component/noise.bin", noise);
    return Activities.zip(files);
  }

  private JsonNode user(String role) {
    return api.post("/api/v1/users", "{\"name\":\"%s\",\"role\":\"%s\"}".formatted(name, role))
        .expect(201)
        .json();
  }

  private String token(JsonNode user) {
    Api.Answer signedIn = signIn("203.0.113.99", name, user.get("password").asString()).expect(200);
    String session =
        signedIn.headers().allValues("Set-Cookie").stream()
            .filter(cookie -> cookie.startsWith("SITAF_SESSION="))
            .findFirst()
            .orElseThrow()
            .split(";", 2)[0];
    Api anonymous = new Api(httpPort(), null);
    return anonymous
        .send(
            anonymous
                .request("/api/v1/tokens")
                .header("Content-Type", "application/json")
                .header("Cookie", "XSRF-TOKEN=x; " + session)
                .header("X-XSRF-TOKEN", "x")
                .POST(BodyPublishers.ofString("{\"name\":\"x\",\"role\":\"TESTER\",\"days\":1}")))
        .expect(201)
        .json()
        .get("secret")
        .asString();
  }

  private Api.Answer signIn(String address, String user, String password) {
    Api anonymous = new Api(httpPort(), null);
    return anonymous.send(
        anonymous
            .request("/api/v1/session")
            .header("Content-Type", "application/json")
            .header("X-Forwarded-For", address)
            .header("X-Forwarded-Proto", "https")
            .header("Cookie", "XSRF-TOKEN=x")
            .header("X-XSRF-TOKEN", "x")
            .POST(
                BodyPublishers.ofString(
                    "{\"name\":\"%s\",\"password\":\"%s\"}".formatted(user, password))));
  }

  /** Sends the headers of a request and the beginning of its body. */
  private Socket begin(String request, String headers, int length, String body) throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), httpPort());
    OutputStream out = socket.getOutputStream();
    out.write(
        (request
                + " HTTP/1.1\r\nHost: localhost\r\nCookie: XSRF-TOKEN=x\r\nX-XSRF-TOKEN: x\r\n"
                + headers
                + "\r\nContent-Length: "
                + length
                + "\r\n\r\n"
                + body)
            .getBytes(StandardCharsets.US_ASCII));
    out.flush();
    return socket;
  }

  private static int statusOf(Socket socket) throws IOException {
    socket.setSoTimeout(60_000);
    byte[] line = socket.getInputStream().readNBytes(12);
    return Integer.parseInt(new String(line, StandardCharsets.US_ASCII).substring(9, 12));
  }
}
