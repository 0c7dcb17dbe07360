package org.sitaf.server.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Base64;
import java.util.List;
import java.util.UUID;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.Browser;
import org.sitaf.server.support.ServerTest;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** Users and scripts sign in; operations that their role does not allow are rejected. */
class AccessStoryTest extends ServerTest {
  @Autowired private JdbcClient jdbc;

  private final String name = "ann-" + UUID.randomUUID().toString().substring(0, 8);
  private String id = "";
  private String password = "";
  private Browser browser = new Browser(0);

  @BeforeEach
  void createUser() {
    JsonNode created =
        api.post("/api/v1/users", "{\"name\":\"%s\",\"role\":\"TESTER\"}".formatted(name))
            .expect(201)
            .json();
    id = created.get("user").get("id").asString();
    password = created.get("password").asString();
    browser = new Browser(httpPort());
  }

  @Test
  void userSignsInAndOut() {
    browser.get("/api/v1/session").expect(401);
    browser.get("/api/v1/builds").expect(401);
    JsonNode caller = browser.signIn(name, password).expect(200).json();
    assertThat(caller.get("role").asString()).isEqualTo("TESTER");
    assertThat(caller.get("kind").asString()).isEqualTo("PERSON");
    browser.get("/api/v1/builds").expect(200);
    browser.get("/api/v1/users").expect(403);
    browser.send("DELETE", "/api/v1/session", "").expect(204);
    browser.get("/api/v1/builds").expect(401);
  }

  @Test
  void sessionCookieIsHttpOnlyAndSameSite() {
    Api.Answer answer = browser.signIn(name, password).expect(200);
    assertThat(answer.headers().allValues("Set-Cookie"))
        .filteredOn(cookie -> cookie.startsWith("SITAF_SESSION="))
        .hasSize(1)
        .allSatisfy(cookie -> assertThat(cookie).contains("HttpOnly").contains("SameSite=Lax"));
  }

  @Test
  void sessionIdsAreStoredAsHashes() {
    browser.signIn(name, password).expect(200);
    String cookie = browser.cookie("SITAF_SESSION").orElseThrow();
    String secret = new String(Base64.getDecoder().decode(cookie), StandardCharsets.UTF_8);
    List<String> stored =
        jdbc.sql("SELECT session_id FROM spring_session WHERE principal_name = ?")
            .param(name)
            .query(String.class)
            .list();
    assertThat(stored).singleElement().isNotEqualTo(secret).isEqualTo(Secret.hash(secret));
    String stolen =
        Base64.getEncoder().encodeToString(stored.get(0).getBytes(StandardCharsets.UTF_8));
    Api anonymous = new Api(httpPort(), null);
    anonymous
        .send(
            anonymous.request("/api/v1/session").header("Cookie", "SITAF_SESSION=" + stolen).GET())
        .expect(401);
    anonymous
        .send(
            anonymous.request("/api/v1/session").header("Cookie", "SITAF_SESSION=" + cookie).GET())
        .expect(200);
  }

  @Test
  void signingInCreatesANewSession() {
    browser.signIn(name, password).expect(200);
    String first = browser.cookie("SITAF_SESSION").orElseThrow();
    browser.signIn(name, password).expect(200);
    assertThat(browser.cookie("SITAF_SESSION").orElseThrow()).isNotEqualTo(first);
  }

  @Test
  void crossSiteRequestsAreRejected() {
    browser.signIn(name, password).expect(200);
    browser
        .sendForged("POST", "/api/v1/tokens", "{\"name\":\"x\",\"role\":\"VIEWER\",\"days\":1}")
        .expect(403);
    browser.sendForged("DELETE", "/api/v1/session", "").expect(403);
    browser.get("/api/v1/session").expect(200);
  }

  @Test
  void wrongPasswordAndUnknownNameGetTheSameResponse() {
    String wrong = browser.signIn(name, password + "x").expect(401).text();
    assertThat(browser.signIn("nobody-" + name, password).expect(401).text()).isEqualTo(wrong);
  }

  @Test
  void guessingPasswordsIsThrottledPerUser() {
    for (int i = 0; i < 5; i++) {
      browser.signIn(name, "a wrong password " + i).expect(401);
    }
    Api.Answer stopped = browser.signIn(name, password).expect(429);
    assertThat(Integer.parseInt(stopped.headers().firstValue("Retry-After").orElseThrow()))
        .isBetween(1, 300);
    JsonNode other =
        api.post("/api/v1/users", "{\"name\":\"other-%s\",\"role\":\"VIEWER\"}".formatted(name))
            .expect(201)
            .json();
    browser.signIn("other-" + name, other.get("password").asString()).expect(200);
  }

  @Test
  void changingThePasswordEndsOtherSessions() {
    browser.signIn(name, password).expect(200);
    Browser elsewhere = new Browser(httpPort());
    elsewhere.signIn(name, password).expect(200);
    String next = "correct horse battery staple";
    String change = "{\"current\":\"%s\",\"next\":\"%s\"}";
    browser
        .send("PUT", "/api/v1/session/password", change.formatted("not " + password, next))
        .expect(400);
    browser
        .send("PUT", "/api/v1/session/password", change.formatted(password, "short"))
        .expect(400);
    browser.send("PUT", "/api/v1/session/password", change.formatted(password, next)).expect(204);
    browser.get("/api/v1/session").expect(200);
    elsewhere.get("/api/v1/session").expect(401);
    new Browser(httpPort()).signIn(name, next).expect(200);
    new Browser(httpPort()).signIn(name, password).expect(401);
  }

  @Test
  void tokenIsLimitedByItsRoleUntilItIsRevoked() {
    browser.signIn(name, password).expect(200);
    JsonNode made = token("VIEWER");
    String secret = made.get("secret").asString();
    assertThat(secret).startsWith("sitaf_");
    Api script = new Api(httpPort(), secret);
    assertThat(script.get("/api/v1/session").expect(200).json().get("kind").asString())
        .isEqualTo("TOKEN");
    script.get("/api/v1/builds").expect(200);
    script.post("/api/v1/builds", "{\"suiteId\":\"none\"}").expect(403);
    JsonNode listed = browser.get("/api/v1/tokens").expect(200).json().get("items").get(0);
    assertThat(listed.has("secret")).isFalse();
    assertThat(listed.get("lastUsed").asString()).isNotEmpty();
    browser
        .send("DELETE", "/api/v1/tokens/" + made.get("token").get("id").asString(), "")
        .expect(204);
    script.get("/api/v1/builds").expect(401);
  }

  @Test
  void tokenIsLimitedByItsOwnersRoleAndDeletedWithTheOwner() {
    browser.signIn(name, password).expect(200);
    browser
        .send("POST", "/api/v1/tokens", "{\"name\":\"x\",\"role\":\"ADMINISTRATOR\",\"days\":1}")
        .expect(403);
    Api script = new Api(httpPort(), token("TESTER").get("secret").asString());
    script.post("/api/v1/tokens", "{\"name\":\"x\",\"role\":\"VIEWER\",\"days\":1}").expect(403);
    change("{\"role\":\"VIEWER\"}");
    browser.get("/api/v1/session").expect(401);
    script.get("/api/v1/builds").expect(200);
    script.post("/api/v1/builds", "{\"suiteId\":\"none\"}").expect(403);
    change("{\"enabled\":false}");
    script.get("/api/v1/builds").expect(401);
    new Browser(httpPort()).signIn(name, password).expect(401);
    change("{\"enabled\":true}");
    script.get("/api/v1/builds").expect(200);
    api.delete("/api/v1/users/" + id).expect(204);
    script.get("/api/v1/builds").expect(401);
  }

  @Test
  void expiredTokenIsRejected() {
    browser.signIn(name, password).expect(200);
    JsonNode made = token("VIEWER");
    jdbc.sql("UPDATE api_token SET expires = CURRENT_TIMESTAMP WHERE id = ?")
        .param(made.get("token").get("id").asString())
        .update();
    new Api(httpPort(), made.get("secret").asString()).get("/api/v1/builds").expect(401);
  }

  @Test
  void usersCannotRevokeTokensOfOthers() {
    browser.signIn(name, password).expect(200);
    String tokenId = token("VIEWER").get("token").get("id").asString();
    JsonNode other =
        api.post("/api/v1/users", "{\"name\":\"other-%s\",\"role\":\"TESTER\"}".formatted(name))
            .expect(201)
            .json();
    Browser others = new Browser(httpPort());
    others.signIn("other-" + name, other.get("password").asString()).expect(200);
    others.send("DELETE", "/api/v1/tokens/" + tokenId, "").expect(404);
    others.get("/api/v1/tokens?all=true").expect(403);
    api.delete("/api/v1/tokens/" + tokenId).expect(204);
  }

  @Test
  void tokensAndPasswordsAreStoredAsHashes() {
    browser.signIn(name, password).expect(200);
    String secret = token("VIEWER").get("secret").asString();
    assertThat(jdbc.sql("SELECT hash FROM api_token").query(String.class).list())
        .doesNotContain(secret)
        .contains(Secret.hash(secret));
    assertThat(
            jdbc.sql("SELECT password_hash FROM person WHERE id = ?")
                .param(id)
                .query(String.class)
                .single())
        .startsWith("$2a$10$")
        .doesNotContain(password);
  }

  @Test
  void signInLinkCanBeUsedOnce() {
    String path = api.post("/api/v1/session/link", "").expect(200).json().get("path").asString();
    Api.Answer opened = browser.get(path).expect(303);
    assertThat(opened.headers().firstValue("Location")).contains("/");
    assertThat(browser.get("/api/v1/session").expect(200).json().get("role").asString())
        .isEqualTo("ADMINISTRATOR");
    Browser late = new Browser(httpPort());
    assertThat(late.get(path).expect(303).headers().firstValue("Location"))
        .contains("/sign-in?link=expired");
    late.get("/api/v1/session").expect(401);
    browser.send("POST", "/api/v1/session/link", "").expect(403);
  }

  @Test
  void signInLinkUpdatesTheLastSignIn() {
    Instant before = Instant.now().truncatedTo(ChronoUnit.MILLIS);
    String path = api.post("/api/v1/session/link", "").expect(200).json().get("path").asString();
    browser.get(path).expect(303);
    String caller = browser.get("/api/v1/session").expect(200).json().get("name").asString();
    assertThat(api.get("/api/v1/users?size=500").expect(200).json().get("items"))
        .filteredOn(user -> user.get("name").asString().equals(caller))
        .singleElement()
        .satisfies(
            user ->
                assertThat(Instant.parse(user.path("lastSignIn").asString()))
                    .isAfterOrEqualTo(before));
  }

  @Test
  void changesAndRejectionsAreInTheAuditLog() {
    browser.signIn(name, password + "x").expect(401);
    browser.signIn(name, password).expect(200);
    token("VIEWER");
    browser.get("/api/v1/users").expect(403);
    JsonNode events = api.get("/api/v1/audit?actor=" + name).expect(200).json().get("items");
    assertThat(events)
        .extracting(e -> e.get("action").asString() + " " + e.get("outcome").asString())
        .containsExactly("denied refused: 403", "createToken done", "signIn done");
    JsonNode failed =
        api.get("/api/v1/audit?action=signIn&actor=-").expect(200).json().get("items").get(0);
    assertThat(failed.get("subject").asString()).isEqualTo(name);
    assertThat(failed.get("outcome").asString()).isEqualTo("refused: 401");
  }

  @Test
  void lastAdministratorCannotBeRemoved() {
    JsonNode administrator = null;
    for (JsonNode user : api.get("/api/v1/users?size=500").expect(200).json().get("items")) {
      if (user.get("role").asString().equals("ADMINISTRATOR")) {
        administrator = user;
      }
    }
    assertThat(administrator).isNotNull();
    String path = "/api/v1/users/" + administrator.get("id").asString();
    api.delete(path).expect(409);
    patch(path, "{\"role\":\"VIEWER\"}").expect(409);
    patch(path, "{\"enabled\":false}").expect(409);
    change("{\"role\":\"ADMINISTRATOR\"}");
    patch(path, "{\"enabled\":false}").expect(200);
    patch(path, "{\"enabled\":true}").expect(200);
    api.delete("/api/v1/users/" + id).expect(204);
  }

  @Test
  void invalidTokenIsRejectedForPublicPages() {
    Api wrong = new Api(httpPort(), "sitaf_" + "x".repeat(43));
    wrong.get("/api/v1/builds").expect(401);
    wrong.get("/").expect(401);
    Api anonymous = new Api(httpPort(), null);
    anonymous.get("/").expect(200);
    anonymous.get("/actuator/health").expect(200);
    anonymous.get("/actuator/prometheus").expect(401);
    assertThat(api.get("/actuator/prometheus").expect(200).text()).contains("jvm_memory_used");
    anonymous.get("/actuator/env").expect(401);
    anonymous.get("/v3/api-docs").expect(401);
  }

  private JsonNode token(String role) {
    return browser
        .send(
            "POST",
            "/api/v1/tokens",
            "{\"name\":\"ci\",\"role\":\"%s\",\"days\":30}".formatted(role))
        .expect(201)
        .json();
  }

  private void change(String json) {
    patch("/api/v1/users/" + id, json).expect(200);
  }

  private Api.Answer patch(String path, String json) {
    return api.send(
        api.request(path)
            .header("Content-Type", "application/json")
            .method("PATCH", java.net.http.HttpRequest.BodyPublishers.ofString(json)));
  }
}
