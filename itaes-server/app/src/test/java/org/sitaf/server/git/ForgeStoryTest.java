package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest.BodyPublishers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.HexFormat;
import java.util.List;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeForge;

/** A forge reports pushes, and shows the statuses of commits. */
@Tag("slow")
class ForgeStoryTest extends GitStory {
  private static final String TOKEN = "forge-token";

  private String withForge(FakeForge forge, String kind) {
    return ", \"forge\": \"%s\", \"apiUrl\": \"%s\", \"project\": \"robots/sensors\", \"forgeToken\": \"%s\""
        .formatted(kind, forge.api(), TOKEN);
  }

  /** The states of a commit when the forge has a final one. */
  private static List<String> states(FakeForge forge, String sha) throws InterruptedException {
    Instant deadline = Instant.now().plus(Duration.ofSeconds(120));
    while (forge.of(sha).size() < 2) {
      if (Instant.now().isAfter(deadline)) {
        throw new AssertionError("no final status: " + forge.of(sha) + forge.problems());
      }
      Thread.sleep(20);
    }
    // A second final status would come soon.
    Thread.sleep(300);
    return forge.of(sha).stream().map(FakeForge.Status::state).toList();
  }

  @ParameterizedTest
  @ValueSource(strings = {"GITHUB", "GITLAB", "GITEA"})
  void aCommitIsPendingAndThenHasOneFinalStatus(String kind) throws Exception {
    boolean gitLab = kind.equals("GITLAB");
    try (FakeForge forge = new FakeForge(TOKEN)) {
      String first = repository.commit("One");
      String activity = create(withForge(forge, kind));
      assertThat(states(forge, first)).containsExactly("pending", "success");
      FakeForge.Status last = forge.of(first).get(1);
      assertThat(last.project()).isEqualTo("robots/sensors");
      assertThat(last.context()).isEqualTo("sitaf/ir-sensor");
      assertThat(last.description()).isEqualTo("55 cases passed");
      assertThat(last.url()).endsWith("/activities/" + activity + "?tab=commits&commit=" + first);

      // The forge stores the statuses, but its answers are lost; then it is away for a moment.
      forge.loseAnswers(2);
      repository.write(DATA_FILE, "2 3");
      String second = repository.commit("Break two cases");
      fetch(activity);
      assertThat(states(forge, second)).containsExactly("pending", gitLab ? "failed" : "failure");
      assertThat(forge.of(second).get(1).description())
          .isEqualTo("2 of 55 cases did not pass; 2 differ from " + first.substring(0, 10));
      forge.fail(3);
      repository.git("rm", "-q", FOLDER + "/activity.yaml");
      String invalid = repository.commit("Remove the profile");
      fetch(activity);
      assertThat(states(forge, invalid)).containsExactly("pending", gitLab ? "failed" : "error");
      assertThat(forge.of(invalid).get(1).description()).contains("holds no activity.yaml");
      assertThat(forge.problems()).isEmpty();
      assertThat(get("/api/v1/activities/" + activity + "/git").toString())
          .contains("\"hasForgeToken\":true")
          .doesNotContain(TOKEN);
    }
  }

  @Test
  void theCommentNamesTheGroupsOfDifferences() {
    String first = repository.commit("One");
    String activity = create("");
    await(activity, first, "DONE");
    repository.write(DATA_FILE, "2 3");
    String second = repository.commit("Two");
    fetch(activity);
    await(activity, second, "DONE");
    String comment =
        api.get("/api/v1/activities/" + activity + "/git/commits/" + second + "/comment")
            .expect(200)
            .text();
    assertThat(comment)
        .contains("2 of 55 cases did not pass; 2 differ from " + first.substring(0, 10))
        .contains("- `GetInfraredData`: 53 of 55 passed; 2 of 55 cases differ")
        .contains("\n  - `")
        .contains("[All results](http://localhost:8080/activities/");
    assertThat(comment.lines().count()).isLessThanOrEqualTo(60);
  }

  private Api.Answer send(String activity, String body, String... headers) {
    return new Api(httpPort(), null)
        .send(
            new Api(httpPort(), null)
                .request("/api/v1/git-hooks/" + activity)
                .headers(headers)
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofString(body)));
  }

  private static String hmac(String secret, String body) throws Exception {
    Mac mac = Mac.getInstance("HmacSHA256");
    mac.init(new SecretKeySpec(secret.getBytes(StandardCharsets.UTF_8), "HmacSHA256"));
    return HexFormat.of().formatHex(mac.doFinal(body.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void aSignedMessageOfEachForgeFetchesOnce() throws Exception {
    String first = repository.commit("One");
    String activity = create("");
    await(activity, first, "DONE");
    String push = "{\"ref\": \"refs/heads/main\"}";
    send(activity, push, "X-GitHub-Event", "push").expect(403);
    String secret =
        api.post("/api/v1/activities/" + activity + "/git/hook", "")
            .expect(201)
            .json()
            .get("secret")
            .asString();
    send(activity, push, "X-GitHub-Event", "push", "X-Hub-Signature-256", "sha256=00").expect(403);
    send(activity, push, "X-Gitlab-Event", "Push Hook", "X-Gitlab-Token", "wrong").expect(403);
    send("no-activity", push, "X-Gitlab-Event", "Push Hook", "X-Gitlab-Token", secret).expect(403);

    String gitHub = repository.commit("Two");
    String[] headers = {
      "X-GitHub-Event", "push",
      "X-GitHub-Delivery", "d-1",
      "X-Hub-Signature-256", "sha256=" + hmac(secret, push)
    };
    send(activity, push, headers).expect(202);
    await(activity, gitHub, "DONE");

    String gitLab = repository.commit("Three");
    send(activity, push, headers).expect(202);
    send(
            activity,
            "{\"ref\": \"refs/heads/other\"}",
            "X-Gitlab-Event",
            "Push Hook",
            "X-Gitlab-Token",
            secret)
        .expect(202);
    Thread.sleep(1000);
    api.get("/api/v1/activities/" + activity + "/git/commits/" + gitLab).expect(404);
    send(
            activity,
            push,
            "X-Gitlab-Event",
            "Push Hook",
            "X-Gitlab-Token",
            secret,
            "X-Gitlab-Event-UUID",
            "u-1")
        .expect(202);
    await(activity, gitLab, "DONE");

    String gitea = repository.commit("Four");
    send(
            activity,
            push,
            "X-Gitea-Event",
            "push",
            "X-Gitea-Delivery",
            "g-1",
            "X-Gitea-Signature",
            hmac(secret, push))
        .expect(202);
    await(activity, gitea, "DONE");
    send(activity, "x".repeat(3 << 20), "X-GitHub-Event", "push").expect(413);
  }
}
