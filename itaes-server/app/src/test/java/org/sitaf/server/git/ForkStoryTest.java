package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sitaf.server.git.RequestHook.Kind;
import org.sitaf.server.support.Api;
import tools.jackson.databind.JsonNode;

/** Code of forks runs only after somebody asked for it. */
@Tag("slow")
class ForkStoryTest extends RequestStory {
  /** Requests that have to do nothing are handled within this time. */
  private static final int SETTLED_MS = 1000;

  private JsonNode awaitApproval(String activity, String head) {
    return awaitRequest(
        activity,
        1,
        request ->
            request.get("waitsForApproval").asBoolean()
                && request.get("head").asString().equals(head));
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void aForkIsFetchedAndBuiltOnlyWhenATesterAsksForItsHead(Kind kind) throws Exception {
    String first = repository.commit("One");
    String activity = createWithHook(forge(kind));
    await(activity, first, "DONE");
    String head = push(kind, 1, first, "2");
    RequestHook opened = RequestHook.opened(kind, 1, head).fromFork();
    send(activity, opened);
    JsonNode waiting = awaitApproval(activity, head);
    assertThat(waiting.get("fork").asBoolean()).isTrue();
    assertThat(waiting.has("commit")).isFalse();
    fetch(activity);
    Thread.sleep(SETTLED_MS);
    assertThat(isFetched(first)).isTrue();
    assertThat(isFetched(head)).as("nothing of the fork was fetched").isFalse();
    assertThat(commitsOf(activity, 1)).isEmpty();

    build(new Api(httpPort(), tokenOf("VIEWER")), activity, 1, head).expect(403);
    build(new Api(httpPort(), null), activity, 1, head).expect(401);
    build(api, activity, 1, "main").expect(400);
    assertThat(build(api, activity, 1, first).expect(409).text()).contains("is now " + head);
    assertThat(isFetched(head)).isFalse();

    build(new Api(httpPort(), tokenOf("TESTER")), activity, 1, head).expect(202);
    JsonNode built = awaitBuilt(activity, 1, head);
    assertThat(built.get("base").asString()).isEqualTo(first);
    assertThat(cell(built).get("differing").asInt()).isEqualTo(1);
    JsonNode request = get(requests(activity) + "/1");
    assertThat(request.get("askedHead").asString()).isEqualTo(head);
    assertThat(request.get("askedBy").asString()).startsWith("tester-");
    assertThat(get("/api/v1/audit?action=buildGitRequest&size=500").get("items"))
        .anyMatch(
            event ->
                event.get("subject").asString().endsWith("/requests/1/build " + head)
                    && event.get("outcome").asString().equals("done")
                    && event.get("actor").asString().startsWith("tester-"));

    String pushed = push(kind, 1, head, "2 3");
    send(activity, opened.head(pushed));
    awaitApproval(activity, pushed);
    Thread.sleep(SETTLED_MS);
    assertThat(isFetched(pushed)).as("a new push needs a new approval").isFalse();
    build(api, activity, 1, head).expect(409);
    build(api, activity, 1, pushed).expect(202);
    awaitBuilt(activity, 1, pushed);
  }

  @Test
  void aHeadThatMovesAfterTheApprovalIsNotBuilt() {
    String first = repository.commit("One");
    String activity = createWithHook(forge(Kind.GITHUB));
    await(activity, first, "DONE");
    String seen = push(Kind.GITHUB, 1, first, "2");
    send(activity, RequestHook.opened(Kind.GITHUB, 1, seen).fromFork());
    // The message about this push is late.
    String moved = push(Kind.GITHUB, 1, first, "2 3");
    build(api, activity, 1, seen).expect(202);
    assertThat(awaitApproval(activity, moved).get("problem").asString())
        .contains("has moved from " + seen + " to " + moved)
        .contains("ask for the build again");
    assertThat(commitsOf(activity, 1)).isEmpty();
    build(api, activity, 1, moved).expect(202);
    awaitBuilt(activity, 1, moved);
  }

  @Test
  void theResultOfAForkIsNotTakenOverByTheBranch() {
    String first = repository.commit("One");
    String activity = createWithHook(forge(Kind.GITHUB));
    await(activity, first, "DONE");
    String head = push(Kind.GITHUB, 1, first, "2");
    send(activity, RequestHook.opened(Kind.GITHUB, 1, head).fromFork());
    build(api, activity, 1, head).expect(202);
    JsonNode built = awaitBuilt(activity, 1, head);
    JsonNode received = built.get("received");
    build(api, activity, 1, head).expect(202);
    awaitRequest(activity, 1, request -> !request.path("commit").path("received").equals(received));
    JsonNode again = awaitBuilt(activity, 1, head);
    assertThat(cell(again).get("buildId"))
        .as("somebody asked to build it again")
        .isNotEqualTo(cell(built).get("buildId"));
    repository.git("merge", "-q", "--squash", head);
    String merged = repository.commit("Merge request 1");
    fetch(activity);
    JsonNode ofBranch = await(activity, merged, "DONE");
    assertThat(cell(ofBranch).get("fail").asInt()).isEqualTo(1);
    assertThat(cell(ofBranch).has("takenFrom")).isFalse();
    repository.write("README.md", "Changed outside of the activity.");
    String next = repository.commit("Change the description");
    fetch(activity);
    assertThat(cell(await(activity, next, "DONE")).get("takenFrom").asString()).isEqualTo(merged);
  }

  @Test
  void anotherBranchForgetsTheRequests() {
    String first = repository.commit("One");
    String activity = createWithHook(forge(Kind.GITHUB));
    await(activity, first, "DONE");
    String head = push(Kind.GITHUB, 1, first, "2");
    send(activity, RequestHook.opened(Kind.GITHUB, 1, head));
    awaitBuilt(activity, 1, head);
    repository.git("branch", "-q", "next");
    api.put(
            "/api/v1/activities/" + activity + "/git",
            "application/json",
            settings(repository.fileUrl(), forge(Kind.GITHUB))
                .replace("\"main\"", "\"next\"")
                .getBytes(java.nio.charset.StandardCharsets.UTF_8),
            "*")
        .expect(200);
    assertThat(get(requests(activity)).get("items")).isEmpty();
    assertThat(commitsOf(activity, 1)).isEmpty();
  }
}
