package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sitaf.server.git.RequestHook.Kind;
import org.sitaf.server.support.FakeForge;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** Requests of the repository itself are built against their merge bases. */
@Tag("slow")
class RequestStoryTest extends RequestStory {
  private static final String TOKEN = "forge-token";

  @Autowired private JdbcClient jdbc;

  @ParameterizedTest
  @EnumSource(Kind.class)
  void aRequestIsComparedWithItsMergeBase(Kind kind) throws Exception {
    try (FakeForge forge = new FakeForge(TOKEN)) {
      String first = repository.commit("One");
      String activity =
          createWithHook(
              forge(kind)
                  .replace("http://localhost:1", forge.api())
                  .replace("\"t\"", "\"" + TOKEN + "\""));
      await(activity, first, "DONE");
      repository.write(DATA_FILE, "1");
      String second = repository.commit("Two");
      fetch(activity);
      await(activity, second, "DONE");

      String head = push(kind, 1, first, "2 3");
      RequestHook opened = RequestHook.opened(kind, 1, head);
      send(activity, opened, "wrong", "d-0").expect(403);
      assertThat(get(requests(activity)).get("items")).isEmpty();
      send(activity, opened, "", "d-1").expect(202);

      JsonNode commit = awaitBuilt(activity, 1, head);
      assertThat(commit.get("base").asString()).isEqualTo(first);
      assertThat(commit.get("request").asInt()).isEqualTo(1);
      assertThat(cell(commit).get("fail").asInt()).isEqualTo(2);
      assertThat(cell(commit).get("differing").asInt()).isEqualTo(2);
      JsonNode build = get("/api/v1/builds/" + cell(commit).get("buildId").asString());
      assertThat(build.get("buildLabels").get("request").asString()).isEqualTo("1");
      assertThat(commitsOf(activity, 1)).hasSize(1);
      assertThat(commits(activity))
          .extracting(c -> c.get("sha").asString())
          .as("the branch has its own commits only")
          .containsExactly(second, first);
      assertThat(api.get("/api/v1/activities/" + activity + "/files/data/failing.txt").text())
          .as("the activity keeps the files of the branch")
          .isEqualTo("1");
      await("/api/v1/activities/" + activity + "/git", unused -> forge.of(head).size() == 2);
      assertThat(forge.of(head).get(0).state()).isEqualTo("pending");
      assertThat(forge.of(head).get(1).description())
          .isEqualTo("2 of 55 cases did not pass; 2 differ from " + first.substring(0, 10));
      assertThat(forge.of(head).get(1).url()).endsWith("&commit=" + head + "&request=1");
      assertThat(
              api.get("/api/v1/activities/" + activity + "/git/commits/" + head + "/comment")
                  .expect(200)
                  .text())
          .contains("2 of 55 cases differ");

      send(activity, opened.action("closed"));
      assertThat(get(requests(activity) + "?state=OPEN").get("items")).isEmpty();
      send(activity, opened, "", "d-1").expect(202);
      assertThat(get(requests(activity) + "/1").get("state").asString())
          .as("a message that was received before does nothing")
          .isEqualTo("CLOSED");
      assertThat(forge.problems()).isEmpty();
    }
  }

  @Test
  void aMergeBaseWithoutResultIsBuiltForTheRequestOnly() throws Exception {
    try (FakeForge forge = new FakeForge(TOKEN)) {
      String first = repository.commit("One");
      String activity =
          createWithHook(
              forge(Kind.GITHUB)
                  .replace("http://localhost:1", forge.api())
                  .replace("\"t\"", "\"" + TOKEN + "\""));
      await(activity, first, "DONE");
      repository.write(DATA_FILE, "1");
      String skipped = repository.commit("Two");
      repository.write(DATA_FILE, "1 2 3 4");
      String third = repository.commit("Three");
      fetch(activity);
      await(activity, third, "DONE");
      String head = push(Kind.GITHUB, 1, skipped, "1 2");
      send(activity, RequestHook.opened(Kind.GITHUB, 1, head));

      JsonNode commit = awaitBuilt(activity, 1, head);
      assertThat(commit.get("base").asString()).isEqualTo(skipped);
      assertThat(cell(commit).get("differing").asInt()).isEqualTo(1);
      JsonNode base = commitsOf(activity, 1).get(1);
      assertThat(base.get("sha").asString()).isEqualTo(skipped);
      assertThat(base.get("mergeBase").asBoolean()).isTrue();
      assertThat(cell(base).get("fail").asInt()).isEqualTo(1);
      assertThat(commits(activity))
          .extracting(c -> c.get("state").asString())
          .containsExactly("DONE", "SKIPPED", "DONE");
      assertThat(forge.of(skipped)).as("a merge base gets no status").isEmpty();

      String next = push(Kind.GITHUB, 1, head, "1 2 5");
      send(activity, RequestHook.opened(Kind.GITHUB, 1, next).head(next));
      awaitBuilt(activity, 1, next);
      assertThat(commitsOf(activity, 1))
          .extracting(c -> c.get("sha").asString())
          .as("the merge base is built once")
          .containsExactly(next, head, skipped);
    }
  }

  @Test
  void aForcePushedHeadIsBuiltAndTheResultOfTheSameRequestIsTakenOver() {
    String first = repository.commit("One");
    String activity = createWithHook(forge(Kind.GITHUB));
    await(activity, first, "DONE");
    String head = push(Kind.GITHUB, 1, first, "2");
    RequestHook opened = RequestHook.opened(Kind.GITHUB, 1, head);
    send(activity, opened);
    JsonNode built = awaitBuilt(activity, 1, head);
    String forced = push(Kind.GITHUB, 1, first, "2");
    send(activity, opened.head(forced));
    JsonNode same = awaitBuilt(activity, 1, forced);
    assertThat(same.get("base").asString()).isEqualTo(first);
    assertThat(cell(same).get("takenFrom").asString()).isEqualTo(head);
    assertThat(cell(same).get("buildId")).isEqualTo(cell(built).get("buildId"));

    // Another request with the same bytes, and then the branch, are built on their own.
    String other = push(Kind.GITHUB, 2, first, "2");
    send(activity, RequestHook.opened(Kind.GITHUB, 2, other));
    assertThat(cell(awaitBuilt(activity, 2, other)).has("takenFrom")).isFalse();
    repository.git("merge", "-q", "--ff-only", forced);
    fetch(activity);
    JsonNode merged =
        await(
                "/api/v1/activities/" + activity + "/git/commits",
                page ->
                    page.get("items").get(0).get("state").asString().equals("DONE")
                        && page.get("items").get(0).get("sha").asString().equals(forced))
            .get("items")
            .get(0);
    assertThat(cell(merged).has("takenFrom")).isFalse();
    assertThat(cell(merged).get("buildId")).isNotEqualTo(cell(built).get("buildId"));
  }

  @Test
  void whatWaitsOfAClosedRequestIsLeftOut() {
    String first = repository.commit("One");
    String activity = createWithHook(forge(Kind.GITHUB));
    await(activity, first, "DONE");
    String head = push(Kind.GITHUB, 1, first, "2");
    RequestHook opened = RequestHook.opened(Kind.GITHUB, 1, head);
    send(activity, opened);
    awaitBuilt(activity, 1, head);
    // Another server works on the source while the request is closed.
    claim(activity, "another server");
    jdbc.sql("UPDATE git_commit SET state = 'WAITING' WHERE sha = ?").param(head).update();
    send(activity, opened.action("closed"));
    claim(activity, null);
    await(activity, head, "SKIPPED");
    assertThat(build(api, activity, 1, head).expect(409).text()).contains("Reopen it");
    send(activity, opened.action("reopened"));
    awaitBuilt(activity, 1, head);
  }

  private void claim(String activity, @Nullable String by) {
    jdbc.sql("UPDATE git_source SET claimed_by = ?, claimed_until = ? WHERE activity_id = ?")
        .params(by, by == null ? null : OffsetDateTime.now(ZoneOffset.UTC).plusHours(1), activity)
        .update();
  }

  @Test
  void aRequestThatCannotBeComparedSaysWhatToDo() {
    String first = repository.commit("One");
    String activity = createWithHook(forge(Kind.GITHUB));
    await(activity, first, "DONE");
    repository.git("checkout", "-q", "--orphan", "unrelated");
    String unrelated = repository.commit("Unrelated");
    repository.git("update-ref", "refs/pull/1/head", unrelated);
    repository.git("checkout", "-q", "main");
    send(activity, RequestHook.opened(Kind.GITHUB, 1, unrelated));
    assertThat(problem(activity, 1))
        .contains("no commit in common with the branch main")
        .contains("Rebase it");
    repository.git("update-ref", "refs/pull/2/head", first);
    send(activity, RequestHook.opened(Kind.GITHUB, 2, first));
    assertThat(problem(activity, 2)).contains("already part of the branch main");
    send(activity, RequestHook.opened(Kind.GITHUB, 3, first));
    assertThat(problem(activity, 3)).contains("has no reference of this request");
    repository.write(DATA_FILE, "1");
    String second = repository.commit("Two");
    fetch(activity);
    await(activity, second, "DONE");
    assertThat(get("/api/v1/activities/" + activity + "/git").has("problem"))
        .as("a request does not stop the branch")
        .isFalse();
    assertThat(commitsOf(activity, 1)).isEmpty();
  }

  private String problem(String activity, int number) {
    return awaitRequest(activity, number, request -> request.has("problem"))
        .get("problem")
        .asString();
  }

  @Test
  void requestsIntoOtherBranchesAndHostileMessagesAreIgnored() {
    String first = repository.commit("One");
    String activity = createWithHook(forge(Kind.GITHUB));
    await(activity, first, "DONE");
    RequestHook opened = RequestHook.opened(Kind.GITHUB, 1, push(Kind.GITHUB, 1, first, "2"));
    send(activity, opened.into("other"));
    send(activity, opened.action("labeled"));
    send(activity, opened.action("closed"));
    send(activity, RequestHook.opened(Kind.GITLAB, 1, first));
    String body = opened.body();
    sendBody(activity, Kind.GITHUB, body.replace("robots/sensors", "other/sensors")).expect(202);
    for (String hostile :
        new String[] {
          body.replace("\"number\": 1", "\"number\": -1"),
          body.replace("\"number\": 1", "\"number\": 1e3"),
          body.replace("\"number\": 1", "\"number\": 99999999999"),
          body.replace("\"number\": 1", "\"number\": \"1/../../heads/main\""),
          body.replace(opened.head(), "HEAD"),
          body.replace(opened.head(), "a".repeat(100_000)),
          "{\"action\": \"opened\"}",
          "no JSON"
        }) {
      sendBody(activity, Kind.GITHUB, hostile).expect(400);
    }
    assertThat(get(requests(activity)).get("items")).isEmpty();
    assertThat(api.get(requests(activity) + "/1").expect(404).text())
        .contains("Add the event of pull or merge requests");

    send(activity, opened.title("\\u0000\\u001b[31m\\u202e" + "x".repeat(100_000)));
    JsonNode request = awaitRequest(activity, 1, found -> true);
    assertThat(request.get("title").asString()).startsWith("  [31m xxx").hasSize(200);
    awaitBuilt(activity, 1, opened.head());
    send(activity, opened.into("other").action("edited"));
    assertThat(get(requests(activity) + "/1").get("state").asString())
        .as("it was moved to another branch")
        .isEqualTo("CLOSED");
  }
}
