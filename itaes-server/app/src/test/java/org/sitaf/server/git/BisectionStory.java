package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import tools.jackson.databind.JsonNode;

/** The first bad commit among those that were left out is found by building some of them. */
@Tag("slow")
abstract class BisectionStory extends GitStory {
  private static String bisections(String activity) {
    return "/api/v1/activities/" + activity + "/git/bisections";
  }

  /** Creates an activity whose first commit has results. */
  private String createBuilt() {
    String first = repository.commit("First");
    String activity = create("");
    await(activity, first, "DONE");
    return activity;
  }

  /** Pushes commits at once, and waits for the results of the last one. */
  private List<String> push(String activity, String... dataOfCommits) {
    List<String> shas = new ArrayList<>();
    for (int i = 0; i < dataOfCommits.length; i++) {
      repository.write(DATA_FILE, dataOfCommits[i]);
      repository.write(FOLDER + "/data/note.txt", "Note " + i);
      shas.add(repository.commit("Change " + i));
    }
    fetch(activity);
    await(activity, shas.get(shas.size() - 1), "DONE");
    return shas;
  }

  private static String asking(String sha, String further) {
    return "{\"commit\": \"%s\"%s}".formatted(sha, further);
  }

  private int begin(String activity, String bad, String further) {
    return api.post(bisections(activity), asking(bad, further))
        .expect(201)
        .json()
        .get("number")
        .asInt();
  }

  private JsonNode awaitState(String activity, int number, String state) {
    return await(
        bisections(activity) + "/" + number,
        search -> search.get("state").asString().equals(state));
  }

  private static String first(JsonNode search) {
    assertThat(search.get("firstBad")).hasSize(1);
    return search.get("firstBad").get(0).get("sha").asString();
  }

  @Test
  void theFirstBadCommitIsFoundWithFewBuilds() {
    String activity = createBuilt();
    String[] data = new String[15];
    for (int i = 0; i < data.length; i++) {
      data[i] = i < 8 ? "" : "7";
    }
    // The one that would be tested first.
    data[6] = NOT_COMPILING;
    List<String> shas = push(activity, data);
    String bad = shas.get(shas.size() - 1);
    JsonNode before = commits(activity);
    int number = begin(activity, bad, "");
    JsonNode search = awaitState(activity, number, "FOUND");

    assertThat(first(search)).isEqualTo(shas.get(8));
    JsonNode found = search.get("firstBad").get(0);
    assertThat(found.get("subject").asString()).isEqualTo("Change 8");
    assertThat(found.get("author").asString()).isEqualTo("Tester");
    assertThat(found.get("reason").asString()).contains("case 7: a wrong value");
    assertThat(search.get("criterion").asString())
        .isEqualTo("Fails: " + Activities.MODEL + ", case 7");
    assertThat(search.get("commits").asInt()).isEqualTo(15);
    assertThat(search.get("left").asInt()).isEqualTo(1);
    assertThat(search.get("tested"))
        .filteredOn(tested -> tested.get("outcome").asString().equals("SKIPPED"))
        .singleElement()
        .satisfies(
            skipped -> {
              assertThat(skipped.get("sha").asString()).isEqualTo(shas.get(6));
              assertThat(skipped.get("reason").asString()).contains("does not compile");
            });
    // ceil(log2(15)) + 1, and one for the commit that does not compile.
    assertThat(search.get("builds").asInt()).isBetween(3, 6);
    assertThat(search.get("tested")).hasSize(search.get("builds").asInt());

    JsonNode result = found.get("results").get(0);
    JsonNode compared =
        get(
            "/api/v1/builds/%s/result/comparison/values?with=%s"
                .formatted(result.get("buildId").asString(), result.get("baseBuildId").asString()));
    assertThat(compared.get("differingCases").asInt()).isEqualTo(1);
    JsonNode build = get("/api/v1/builds/" + result.get("buildId").asString());
    assertThat(build.get("commit").asString()).isEqualTo(shas.get(8));
    assertThat(build.get("priority").asInt()).as("other builds run first").isNegative();
    assertThat(build.get("buildLabels").get("bisection").asString())
        .isEqualTo(Integer.toString(number));
    JsonNode baseBuild = get("/api/v1/builds/" + result.get("baseBuildId").asString());
    assertThat(baseBuild.get("commit").asString()).as("the commit before").isEqualTo(shas.get(7));
    assertThat(commits(activity)).as("the branch and its history do not change").isEqualTo(before);
    assertThat(api.get("/api/v1/activities/" + activity + "/files/data/note.txt").text())
        .isEqualTo("Note 14");
    assertThat(get(bisections(activity)).get("items").get(0)).isEqualTo(search);
    assertThat(get("/api/v1/audit?action=beginGitBisection&size=500").get("items"))
        .anyMatch(event -> event.get("subject").asString().endsWith("/bisections " + bad));
  }

  @Test
  void aSearchCanConcernOneCaseOrItsValues() {
    String activity = createBuilt();
    List<String> shas = push(activity, "", "", "3", "3", "3", "3 7", "3 7");
    String bad = shas.get(6);
    assertThat(first(awaitState(activity, begin(activity, bad, ""), "FOUND")))
        .as("the first commit with anything new")
        .isEqualTo(shas.get(2));
    String model = ", \"model\": \"" + Activities.MODEL + "\"";
    int ofCase = begin(activity, bad, model + ", \"caseNo\": 7");
    assertThat(first(awaitState(activity, ofCase, "FOUND"))).isEqualTo(shas.get(5));
    int ofValues = begin(activity, bad, model + ", \"caseNo\": 7, \"values\": true");
    JsonNode search = awaitState(activity, ofValues, "FOUND");
    assertThat(first(search)).isEqualTo(shas.get(5));
    assertThat(search.get("kind").asString()).isEqualTo("VALUES");
    assertThat(search.get("firstBad").get(0).get("reason").asString())
        .contains("case 7")
        .contains("42.0 instead of");
    assertThat(search.get("builds").asInt())
        .as("what an earlier search has built is taken over")
        .isZero();
    assertThat(
            api.post(bisections(activity), asking(bad, model + ", \"caseNo\": 8"))
                .expect(409)
                .text())
        .contains("leave out model, case and output");
    api.post(bisections(activity), asking(bad, ", \"output\": \"no such output\"")).expect(409);
  }

  @Test
  void commitsThatCannotBeTestedLeaveDoubt() {
    String activity = createBuilt();
    List<String> shas = push(activity, "", NOT_COMPILING, "7");
    repository.git("rm", "-q", FOLDER + "/activity.yaml");
    repository.commit("Remove the profile");
    repository.git("checkout", "-q", "HEAD^", "--", FOLDER);
    shas = new ArrayList<>(shas);
    shas.addAll(push(activity, "7", "7 8"));
    int number = begin(activity, shas.get(2), "");
    JsonNode search = awaitState(activity, number, "UNCERTAIN");
    assertThat(search.get("firstBad"))
        .extracting(commit -> commit.get("sha").asString())
        .containsExactly(shas.get(1), shas.get(2));
    assertThat(search.get("left").asInt()).isEqualTo(2);

    number = begin(activity, shas.get(4), "");
    search = awaitState(activity, number, "FOUND");
    assertThat(first(search)).isEqualTo(shas.get(4));
    assertThat(search.get("tested"))
        .filteredOn(tested -> tested.get("outcome").asString().equals("SKIPPED"))
        .singleElement()
        .satisfies(
            skipped ->
                assertThat(skipped.get("reason").asString()).contains("holds no activity.yaml"));
  }

  @Test
  void onlyATesterMayBeginAndCancelASearch() {
    String activity = createBuilt();
    List<String> shas = push(activity, "", "", "7", "7", "7");
    String bad = shas.get(4);
    Api viewer = new Api(httpPort(), tokenOf("VIEWER"));
    Api tester = new Api(httpPort(), tokenOf("TESTER"));
    viewer.post(bisections(activity), asking(bad, "")).expect(403);
    new Api(httpPort(), null).post(bisections(activity), asking(bad, "")).expect(401);
    assertThat(get(bisections(activity)).get("items")).isEmpty();

    hold(true);
    JsonNode begun = tester.post(bisections(activity), asking(bad, "")).expect(201).json();
    assertThat(begun.get("askedBy").asString()).startsWith("tester-");
    assertThat(begun.get("state").asString()).isEqualTo("RUNNING");
    String search = bisections(activity) + "/1";
    assertThat(api.post(bisections(activity), asking(bad, "")).expect(409).text())
        .contains("Search 1 of this branch runs");
    viewer.get(search).expect(200);
    viewer.post(search + "/cancel", "").expect(403);
    await(
        "/api/v1/builds?size=500&activityId=" + activity,
        builds -> builds.get("items").get(0).get("buildLabels").has("bisection"));
    tester.post(search + "/cancel", "").expect(200);
    tester.post(search + "/cancel", "").expect(409);
    assertThat(get(search).get("state").asString()).isEqualTo("CANCELLED");
    await(
        "/api/v1/builds?size=500&activityId=" + activity,
        builds -> builds.get("items").get(0).get("state").asString().equals("CANCELLED"));
    hold(false);
    assertThat(first(awaitState(activity, begin(activity, bad, ""), "FOUND")))
        .as("builds that were cancelled are not taken over")
        .isEqualTo(shas.get(2));
  }

  @Test
  void aForcePushEndsASearch() {
    String activity = createBuilt();
    String first = repository.git("rev-parse", "HEAD").strip();
    List<String> shas = push(activity, "", "", "7", "7", "7");
    hold(true);
    int number = begin(activity, shas.get(4), "");
    await(
        "/api/v1/builds?size=500&activityId=" + activity,
        builds -> builds.get("items").get(0).get("buildLabels").has("bisection"));
    repository.git("reset", "-q", "--hard", first);
    repository.write(DATA_FILE, "1 2");
    String other = repository.commit("Other");
    fetch(activity);
    JsonNode search = awaitState(activity, number, "FAILED");
    assertThat(search.get("problem").asString())
        .contains("A force-push has removed " + shas.get(4))
        .contains("Ask again at the new commit");
    assertThat(search.get("firstBad")).isEmpty();
    hold(false);
    await(activity, other, "DONE");
    assertThat(api.post(bisections(activity), asking(shas.get(4), "")).expect(409).text())
        .contains("A force-push has removed");
  }

  @Test
  void aDeletedBranchDoesNotStopASearch() {
    String activity = createBuilt();
    List<String> shas = push(activity, "", "", "7", "7", "7");
    hold(true);
    int number = begin(activity, shas.get(4), "");
    repository.git("checkout", "-q", "-b", "other");
    repository.git("branch", "-q", "-D", "main");
    fetch(activity);
    await("/api/v1/activities/" + activity + "/git", source -> source.has("problem"));
    hold(false);
    assertThat(first(awaitState(activity, number, "FOUND")))
        .as("the server has the commits")
        .isEqualTo(shas.get(2));
  }

  @Test
  void anotherFolderEndsASearch() {
    String activity = createBuilt();
    List<String> shas = push(activity, "", "", "7", "7", "7");
    hold(true);
    int number = begin(activity, shas.get(4), "");
    api.put(
            "/api/v1/activities/" + activity + "/git",
            "application/json",
            settings(repository.fileUrl(), "")
                .replace(FOLDER, "elsewhere")
                .getBytes(java.nio.charset.StandardCharsets.UTF_8),
            "*")
        .expect(200);
    assertThat(awaitState(activity, number, "FAILED").get("problem").asString())
        .contains("the folder of the Git source was changed");
  }

  @Test
  void whatCannotBeSearchedIsRefused() {
    String activity = createBuilt();
    List<String> shas = push(activity, "7");
    assertThat(api.post(bisections(activity), asking(shas.get(0), "")).expect(409).text())
        .contains("There is no commit between")
        .contains("came with " + shas.get(0).substring(0, 10));
    List<String> more = push(activity, "7", "7", "7");
    assertThat(api.post(bisections(activity), asking(more.get(2), "")).expect(409).text())
        .contains("No case that passed")
        .contains("none gives other values");
    assertThat(api.post(bisections(activity), asking(more.get(1), "")).expect(409).text())
        .contains("has no results (SKIPPED)");
    api.post(bisections(activity), asking("0".repeat(40), "")).expect(404);
    api.post(bisections(activity), asking("main", "")).expect(400);
    api.post(bisections(activity), "{}").expect(400);
    api.post(bisections(activity), asking(more.get(2), ", \"caseNo\": 7")).expect(400);
    api.post(bisections(activity), asking(more.get(2), ", \"model\": \"M\", \"caseNo\": 0"))
        .expect(400);
    assertThat(
            api.post(bisections(activity), asking(more.get(2), ", \"model\": \"\\u0000\""))
                .expect(409)
                .text())
        .contains("has no result");
    api.get(bisections(activity) + "/1").expect(404);
    api.post(bisections("unknown"), asking(more.get(2), "")).expect(404);
  }
}
