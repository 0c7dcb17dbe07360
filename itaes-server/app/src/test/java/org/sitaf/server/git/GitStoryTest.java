package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import tools.jackson.databind.JsonNode;

/** Commits of a branch become builds of the activity. */
@Tag("slow")
class GitStoryTest extends GitStory {
  private static JsonNode cell(JsonNode commit) {
    assertThat(commit.get("cells")).hasSize(1);
    return commit.get("cells").get(0);
  }

  private String sourceProblem(String activity) {
    fetch(activity);
    return await("/api/v1/activities/" + activity + "/git", source -> source.has("problem"))
        .get("problem")
        .asString();
  }

  @Test
  void commitsAreBuiltAndComparedWithTheOneBefore() {
    String first = repository.commit("Add the sensor");
    String activity = create("");
    JsonNode built = await(activity, first, "DONE");
    assertThat(built.get("subject").asString()).isEqualTo("Add the sensor");
    assertThat(built.has("base")).isFalse();
    assertThat(cell(built).get("pass").asInt()).isEqualTo(55);
    JsonNode build = get("/api/v1/builds/" + cell(built).get("buildId").asString());
    assertThat(build.get("commit").asString()).isEqualTo(first);
    assertThat(build.get("buildLabels").get("branch").asString()).isEqualTo("main");

    repository.write(DATA_FILE, "2 3");
    String second = repository.commit("Break two cases");
    fetch(activity);
    JsonNode broken = await(activity, second, "DONE");
    assertThat(broken.get("base").asString()).isEqualTo(first);
    assertThat(cell(broken).get("fail").asInt()).isEqualTo(2);
    assertThat(cell(broken).get("compared").asInt()).isEqualTo(55);
    assertThat(cell(broken).get("differing").asInt()).isEqualTo(2);
    assertThat(cell(broken).has("takenFrom")).isFalse();
    assertThat(api.get("/api/v1/activities/" + activity + "/files/data/failing.txt").text())
        .as("the activity has the files of the branch")
        .isEqualTo("2 3");

    repository.write("README.md", "Changed outside of the activity.");
    String third = repository.commit("Change the description");
    fetch(activity);
    JsonNode same = await(activity, third, "DONE");
    assertThat(cell(same).get("takenFrom").asString()).isEqualTo(second);
    assertThat(cell(same).get("buildId")).isEqualTo(cell(broken).get("buildId"));
    assertThat(cell(same).get("differing").asInt()).isZero();
    assertThat(commits(activity))
        .extracting(c -> c.get("sha").asString())
        .containsExactly(third, second, first);
  }

  @Test
  void onlyTheNewestCommitOfAPushIsBuiltUnlessAllAreWanted() {
    repository.commit("One");
    String latest = create("");
    String every = create(", \"policy\": \"EVERY\"");
    repository.write(DATA_FILE, "1");
    String two = repository.commit("Two");
    repository.write(DATA_FILE, "1 2");
    String three = repository.commit("Three");
    fetch(latest);
    fetch(every);
    await(latest, three, "DONE");
    assertThat(await(latest, two, "SKIPPED").get("cells")).isEmpty();
    assertThat(cell(await(every, three, "DONE")).get("differing").asInt()).isEqualTo(1);
    await(every, two, "DONE");
  }

  @Test
  void filesFromGitAreNotEditedOnTheServer() {
    repository.commit("One");
    String activity = create("");
    assertThat(
            api.put(
                    "/api/v1/activities/" + activity + "/content",
                    "application/zip",
                    Activities.zip(),
                    "*")
                .expect(409)
                .text())
        .contains("Push the change there");
    api.delete("/api/v1/activities/" + activity + "/git").expect(204);
    api.get("/api/v1/activities/" + activity + "/git").expect(404);
    api.put("/api/v1/activities/" + activity + "/content", "application/zip", Activities.zip(), "*")
        .expect(200);
  }

  @Test
  void aCommitThatCannotBeBuiltLeavesTheLastGoodState() throws IOException {
    repository.commit("One");
    String activity = create("");
    repository.git("rm", "-q", FOLDER + "/activity.yaml");
    String without = repository.commit("Remove the profile");
    fetch(activity);
    assertThat(await(activity, without, "INVALID").get("problem").asString())
        .contains("holds no activity.yaml")
        .contains("set the folder");
    repository.git("checkout", "-q", "HEAD^", "--", FOLDER);
    Files.createSymbolicLink(
        repository.folder().resolve(FOLDER + "/data/link"), Path.of("/etc/passwd"));
    String link = repository.commit("Add a link");
    fetch(activity);
    assertThat(await(activity, link, "INVALID").get("problem").asString())
        .contains("data/link is a link");
    repository.git("rm", "-q", FOLDER + "/data/link");
    for (int i = 0; i <= 10_000; i++) {
      Files.createDirectories(repository.folder().resolve(FOLDER + "/many/" + i % 10));
      Files.writeString(repository.folder().resolve(FOLDER + "/many/" + i % 10 + "/" + i), "");
    }
    String many = repository.commit("Add 10,001 files");
    fetch(activity);
    assertThat(await(activity, many, "INVALID").get("problem").asString())
        .contains("more than 10000 files");
    assertThat(get("/api/v1/activities/" + activity).get("name").asString()).isEqualTo("ir-sensor");
    repository.git("rm", "-rq", FOLDER + "/many");
    String repaired = repository.commit("Repair");
    fetch(activity);
    JsonNode good = await(activity, repaired, "DONE");
    assertThat(good.get("base").asString())
        .as("the nearest commit that could be built")
        .isEqualTo(commits(activity).get(4).get("sha").asString());
  }

  @Test
  void aCommitThatNeedsRealDevicesIsNotBuilt() {
    repository.commit("One");
    String activity = create("");
    String profile =
        new String(Activities.files().get("activity.yaml"), StandardCharsets.UTF_8).stripTrailing();
    repository.write(
        FOLDER + "/activity.yaml", profile + "\nhardware: {ir7: {backend: provider}}\n");
    String real = repository.commit("Use a real device");
    fetch(activity);
    // Nobody with the role has requested it.
    assertThat(await(activity, real, "INVALID").get("problem").asString())
        .contains("uses real devices (ir7)")
        .contains("the role OPERATOR");
    assertThat(get("/api/v1/builds?size=500").get("items"))
        .noneMatch(b -> b.path("commit").path("sha").asString("").equals(real));
  }

  @Test
  void aForcePushMarksWhatItRemoved() {
    String first = repository.commit("One");
    String activity = create("");
    await(activity, first, "DONE");
    repository.write(DATA_FILE, "1");
    String removed = repository.commit("Two");
    fetch(activity);
    await(activity, removed, "DONE");
    repository.git("reset", "-q", "--hard", first);
    repository.write(DATA_FILE, "1 2");
    String other = repository.commit("Other two");
    fetch(activity);
    JsonNode pushed = await(activity, other, "DONE");
    assertThat(pushed.get("base").asString()).isEqualTo(first);
    assertThat(await(activity, removed, "DONE").get("replaced").asBoolean()).isTrue();
    assertThat(pushed.get("replaced").asBoolean()).isFalse();
  }

  @Test
  void aRepositoryThatCannotBeFetchedIsReportedAndTheLastStateStays() throws IOException {
    String first = repository.commit("One");
    String activity = create("");
    await(activity, first, "DONE");
    repository.git("checkout", "-q", "-b", "other");
    repository.git("branch", "-q", "-D", "main");
    assertThat(sourceProblem(activity)).contains("deleted or renamed").contains("another branch");
    repository.git("checkout", "-q", "-b", "main");
    byte[] noise = new byte[5 << 20];
    new Random(1).nextBytes(noise);
    repository.write("large.bin", noise);
    repository.commit("Add a large file");
    fetch(activity);
    await(
        "/api/v1/activities/" + activity + "/git",
        source ->
            source.has("problem")
                && source.get("problem").asString().contains("larger than 4 MiB"));
    Files.move(repository.folder(), repository.folder().resolveSibling("away-" + activity));
    fetch(activity);
    await(
        "/api/v1/activities/" + activity + "/git",
        source ->
            source.has("problem")
                && source.get("problem").asString().contains("There is no repository at"));
    assertThat(commits(activity)).hasSize(1);
    assertThat(get("/api/v1/activities/" + activity + "/git").get("head").asString())
        .isEqualTo(first);
  }

  @Test
  void hostileAddressesAndNamesAreRefused() {
    repository.commit("One");
    for (String url :
        new String[] {
          "ext::sh -c touch% /tmp/owned",
          "ext::sh",
          "--upload-pack=touch",
          "-oProxyCommand=touch@host:x",
          "ssh://-oProxyCommand=touch/x",
          "git@-host:x",
          "git@host:-x",
          "https://user:token@localhost/x",
          "http://other.example.org/x",
          "git://localhost/x",
          "ftp://localhost/x",
          "file:///etc",
          "file://" + REPOSITORIES + "/../../secret",
          "file://host" + REPOSITORIES,
          "/etc/passwd",
          "https://localhost/x?service=y",
          ""
        }) {
      Api.Answer answer = api.post("/api/v1/git-activities", settings(url, "")).expect(400);
      assertThat(answer.json().get("detail").asString()).startsWith("url");
    }
    for (String branch : new String[] {"--upload-pack=x", "a..b", "a b", "", "x.lock", "a:b"}) {
      api.post(
              "/api/v1/git-activities",
              "{\"url\": \"%s\", \"branch\": \"%s\"}".formatted(repository.fileUrl(), branch))
          .expect(400);
    }
    api.post(
            "/api/v1/git-activities",
            "{\"url\": \"%s\", \"branch\": \"main\", \"folder\": \"../x\"}"
                .formatted(repository.fileUrl()))
        .expect(400);
    assertThat(
            api.post(
                    "/api/v1/git-activities",
                    "{\"url\": \"%s\", \"branch\": \"main\", \"folder\": \"nowhere\"}"
                        .formatted(repository.fileUrl()))
                .expect(422)
                .text())
        .contains("the folder does not exist in this commit");
  }
}
