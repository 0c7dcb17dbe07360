package org.sitaf.server.git;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import tools.jackson.databind.JsonNode;

/** A case is followed through the commits of a branch. */
@Tag("slow")
class CaseHistoryStoryTest extends GitStory {
  private static final String MODEL_FILE = FOLDER + "/GetInfraredData.xml";

  private JsonNode history(String activity, String parameters) {
    return get(
        "/api/v1/activities/"
            + activity
            + "/case-history?model="
            + Activities.MODEL
            + "&"
            + parameters);
  }

  private static List<String> values(JsonNode history, String name) {
    return history
        .get("items")
        .valueStream()
        .map(item -> item.has(name) ? item.get(name).asString() : "-")
        .toList();
  }

  private static String build(JsonNode commit) {
    return commit.get("cells").get(0).get("buildId").asString();
  }

  /** Numbers of cases by their inputs. */
  private Map<String, Integer> cases(String build) {
    Map<String, Integer> cases = new HashMap<>();
    for (JsonNode item : get("/api/v1/builds/" + build + "/result/cases?size=500").get("items")) {
      cases.put(item.get("values").toString(), item.get("no").asInt());
    }
    return cases;
  }

  @Test
  void commitsAreThePointsOfTheLine() {
    String first = repository.commit("Add the sensor");
    String activity = create("");
    String firstBuild = build(await(activity, first, "DONE"));
    repository.write(DATA_FILE, "2 3");
    String second = repository.commit("Break two cases");
    fetch(activity);
    await(activity, second, "DONE");
    repository.write("README.md", "Changed outside of the activity.");
    String third = repository.commit("Change the description");
    fetch(activity);
    await(activity, third, "DONE");
    repository.git("rm", "-q", FOLDER + "/activity.yaml");
    String fourth = repository.commit("Remove the profile");
    fetch(activity);
    await(activity, fourth, "INVALID");

    JsonNode line = history(activity, "no=2");
    assertThat(line.get("by").asString()).isEqualTo("COMMITS");
    assertThat(line.get("total").asInt()).isEqualTo(4);
    assertThat(values(line, "commit")).containsExactly(fourth, third, second, first);
    assertThat(values(line, "state")).containsExactly("INVALID", "JUDGED", "JUDGED", "JUDGED");
    assertThat(line.get("items").get(0).get("reason").asString()).contains("activity.yaml");
    assertThat(values(line, "verdict")).containsExactly("-", "FAIL", "FAIL", "PASS");
    assertThat(values(line, "takenFrom")).containsExactly("-", second, "-", "-");
    assertThat(values(line, "verdictChanged")).containsExactly("-", "false", "true", "-");
    assertThat(values(line, "valueChanged")).containsExactly("-", "false", "true", "-");
    assertThat(line.get("items").get(2).get("subject").asString()).isEqualTo("Break two cases");

    // Page by page, the same marks.
    List<String> marks = new ArrayList<>();
    for (int page = 0; page < 4; page++) {
      marks.addAll(values(history(activity, "no=2&size=1&page=" + page), "verdictChanged"));
    }
    assertThat(marks).isEqualTo(values(line, "verdictChanged"));
    assertThat(values(history(activity, "no=5"), "valueChanged"))
        .containsExactly("-", "false", "false", "-");
    assertThat(values(history(activity, "no=2&by=BUILDS"), "buildId"))
        .hasSize(2)
        .endsWith(firstBuild);
  }

  @Test
  void aCaseKeepsItsLineWhenAChangeOfTheModelNumbersTheCasesDifferently() {
    String first = repository.commit("Add the sensor");
    String activity = create("");
    String before = build(await(activity, first, "DONE"));
    String model = new String(Activities.files().get("GetInfraredData.xml"), UTF_8);
    // Other distances, and more combinations: cases are added, removed and renumbered.
    String changed =
        model
            .replace("max=\"10.0\"", "max=\"12.0\"")
            .replace("<order_of_combinations>2<", "<order_of_combinations>all<");
    assertThat(changed).contains("12.0", ">all<");
    repository.write(MODEL_FILE, changed);
    String second = repository.commit("Extend the range");
    fetch(activity);
    String after = build(await(activity, second, "DONE"));
    Map<String, Integer> numbersAfter = cases(after);
    int renumbered = 0;
    int absent = 0;
    for (Map.Entry<String, Integer> each : cases(before).entrySet()) {
      int no = each.getValue();
      JsonNode newest = history(activity, "no=" + no + "&build=" + before).get("items").get(0);
      assertThat(newest.get("commit").asString()).isEqualTo(second);
      Integer now = numbersAfter.get(each.getKey());
      if (now == null) {
        absent++;
        assertThat(newest.get("state").asString()).isEqualTo("ABSENT");
        assertThat(newest.get("reason").asString()).contains("no case with these inputs");
      } else {
        renumbered += now == no ? 0 : 1;
        assertThat(newest.get("no").asInt()).isEqualTo(now);
      }
    }
    assertThat(absent).isPositive();
    assertThat(renumbered).as("cases with another number").isPositive();
  }

  @Test
  void aCommitThatAForcePushRemovedIsMarkedAndNoPredecessor() {
    String first = repository.commit("One");
    String activity = create("");
    await(activity, first, "DONE");
    repository.write(DATA_FILE, "2");
    String removed = repository.commit("Two");
    fetch(activity);
    await(activity, removed, "DONE");
    repository.git("reset", "-q", "--hard", first);
    repository.write(DATA_FILE, "3");
    String other = repository.commit("Another");
    fetch(activity);
    await(activity, other, "DONE");
    JsonNode line = history(activity, "no=2");
    assertThat(values(line, "commit")).containsExactly(other, removed, first);
    assertThat(values(line, "replaced")).containsExactly("false", "true", "false");
    assertThat(values(line, "verdictChanged")).containsExactly("false", "-", "-");
  }
}
