package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.UUID;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.TrajectoryResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.server.result.Results;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** The line of a case through the builds of a model. */
abstract class CaseHistoryStory extends AnalysisStory {
  private static final String LONG = "x".repeat(3000);

  @Autowired private JdbcClient jdbc;

  private String built(String options, UnaryOperator<CaseResult> change) {
    String id = request(options);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "of-history", "java")) {
      Assignment assignment = agent.nextAssignment();
      TestResult result = Results.read(FakeAgent.result(agent.download(assignment), List.of()));
      ByteArrayOutputStream document = new ByteArrayOutputStream();
      TestResultXml.write(
          new TestResult(
              result.name(),
              result.provenance(),
              result.summary(),
              result.parameters(),
              result.cases().stream().map(change).toList(),
              null),
          document);
      assertThat(agent.submit(assignment.getAttempt(), document.toByteArray())).isTrue();
    }
    return id;
  }

  private static CaseResult measured(CaseResult result) {
    return result
        .with(
            List.of(
                new TrajectoryResult("stays away", Verdict.PASS, 0.75, 1.0),
                new TrajectoryResult("stops", Verdict.PASS, 0.25, 2.0),
                new TrajectoryResult("arrives", Verdict.PASS, Double.POSITIVE_INFINITY, 2.0)))
        .with(RepeatedCalls.of(1, new long[] {3000, 1000, 2000}, ""));
  }

  private static CaseResult failing(CaseResult result) {
    return new CaseResult(
        result.no(),
        Verdict.FAIL,
        result.values(),
        result.expected(),
        List.of(new NamedValue("", LONG)),
        result.time(),
        LONG);
  }

  private static CaseResult inLastBits(CaseResult result) {
    double value = Double.parseDouble(result.actual().get(0).literal());
    return new CaseResult(
        result.no(),
        result.verdict(),
        result.values(),
        result.expected(),
        List.of(new NamedValue("", Double.toString(Math.nextUp(value)))),
        result.time(),
        result.message());
  }

  private JsonNode history(String parameters) {
    return api.get(path(parameters)).expect(200).json();
  }

  private String path(String parameters) {
    return "/api/v1/activities/" + activityId + "/case-history?model=" + parameters;
  }

  private static List<String> values(JsonNode history, String name) {
    return history
        .get("items")
        .valueStream()
        .map(item -> item.has(name) ? item.get(name).asString() : "-")
        .toList();
  }

  @Test
  void aCaseIsFollowedThroughTheBuildsOfItsModel() {
    String first = built("\"commit\": \"abc123\"", CaseHistoryStory::measured);
    String second = built("\"commit\": \"def456\"", r -> r.no() == 7 ? failing(r) : inLastBits(r));
    String cancelled = request("\"commit\": \"aaa\"");
    api.post("/api/v1/builds/" + cancelled + "/cancel", "");
    String waiting = request("\"priority\": 1");

    JsonNode line = history(Activities.MODEL + "&no=7");
    assertThat(line.get("by").asString()).isEqualTo("BUILDS");
    assertThat(line.get("buildId").asString()).as("with the newest result").isEqualTo(second);
    assertThat(line.get("parameters"))
        .extracting(JsonNode::asString)
        .containsExactly("IndexOfSensor", "NumOfSensor", "Distance");
    assertThat(line.get("values")).hasSize(3);
    assertThat(line.get("total").asInt()).isEqualTo(4);
    assertThat(values(line, "buildId")).containsExactly(waiting, cancelled, second, first);
    assertThat(values(line, "commit")).containsExactly("-", "aaa", "def456", "abc123");
    assertThat(values(line, "state")).containsExactly("PENDING", "NO_RESULT", "JUDGED", "JUDGED");
    assertThat(values(line, "verdict")).containsExactly("-", "-", "FAIL", "PASS");
    assertThat(values(line, "verdictChanged")).containsExactly("-", "-", "true", "-");
    assertThat(values(line, "valueChanged")).containsExactly("-", "-", "true", "-");

    JsonNode failed = line.get("items").get(2);
    assertThat(failed.get("actual").get("return").asString()).hasSize(201);
    assertThat(failed.get("message").asString()).hasSize(1001);
    assertThat(failed.has("margin")).isFalse();
    assertThat(failed.get("time").get("medianUs").asDouble()).isEqualTo(7);
    assertThat(failed.get("time").get("calls").asInt()).isZero();
    JsonNode passed = line.get("items").get(3);
    assertThat(passed.get("margin").get("condition").asString()).isEqualTo("stops");
    assertThat(passed.get("margin").get("value").asString()).isEqualTo("0.25");
    assertThat(passed.get("time").get("medianUs").asDouble()).isEqualTo(2);
    assertThat(passed.get("time").get("calls").asInt()).isEqualTo(3);

    // The double that follows is no other value, as in a comparison.
    assertThat(values(history(Activities.MODEL + "&no=8"), "valueChanged"))
        .containsExactly("-", "-", "false", "-");
    JsonNode page = history(Activities.MODEL + "&no=7&size=1&page=2");
    assertThat(values(page, "buildId")).containsExactly(second);
    assertThat(values(page, "verdictChanged")).as("against the next page").containsExactly("true");
    assertThat(page.get("total").asInt()).isEqualTo(4);
  }

  @Test
  void commitsAreReadFromEachDatabase() {
    String first = built("\"commit\": \"abc123\"", r -> r);
    String second = built("\"commit\": \"def456\"", r -> r.no() == 7 ? failing(r) : r);
    String source = UUID.randomUUID().toString();
    jdbc.sql(
            "INSERT INTO git_source (id, activity_id, url, branch, folder, credential_kind,"
                + " credential_user, policy, interval_s, version, created)"
                + " SELECT ?, id, 'https://git.invalid/a', 'main', '', 'NONE', '', 'EVERY', 3600, 0,"
                + " created FROM activity WHERE id = ?")
        .params(source, activityId)
        .update();
    try {
      commit(source, 1, "DONE", first);
      commit(source, 2, "SKIPPED", null);
      commit(source, 3, "DONE", second);
      commit(source, 4, "WAITING", null);
      JsonNode line = history(Activities.MODEL + "&no=7");
      assertThat(line.get("by").asString()).isEqualTo("COMMITS");
      assertThat(line.get("buildId").asString()).isEqualTo(second);
      assertThat(values(line, "state")).containsExactly("PENDING", "JUDGED", "NOT_BUILT", "JUDGED");
      assertThat(values(line, "verdictChanged")).containsExactly("-", "true", "-", "-");
      assertThat(values(history(Activities.MODEL + "&no=7&size=2"), "valueChanged"))
          .as("against the next page")
          .containsExactly("-", "true");
    } finally {
      jdbc.sql("DELETE FROM git_source WHERE id = ?").param(source).update();
    }
  }

  private void commit(String source, int position, String state, @Nullable String build) {
    String id = UUID.randomUUID().toString();
    jdbc.sql(
            "INSERT INTO git_commit (id, source_id, sha, request_no, position, subject, author,"
                + " authored, received, state) SELECT ?, id, ?, 0, ?, 'Change it', 'Tester',"
                + " created, created, ? FROM git_source WHERE id = ?")
        .params(id, "sha" + position, position, state, source)
        .update();
    if (build != null) {
      jdbc.sql(
              "INSERT INTO git_cell (commit_id, model, position, digest, build_id)"
                  + " VALUES (?, ?, 0, 'digest', ?)")
          .params(id, Activities.MODEL, build)
          .update();
    }
  }

  @Test
  void theValidityOfACaseIsThatOfItsSuite() {
    String build = built("\"priority\": 0", r -> r);
    JsonNode cases = api.get("/api/v1/suites/" + suiteId + "/cases?size=100").expect(200).json();
    for (JsonNode item : cases.get("items")) {
      int no = item.get("no").asInt();
      JsonNode line = history(Activities.MODEL + "&no=" + no + "&build=" + build);
      assertThat(line.get("items").get(0).get("valid").asBoolean())
          .isEqualTo(item.get("valid").asBoolean());
    }
    assertThat(cases.get("items"))
        .extracting(c -> c.get("valid").asBoolean())
        .contains(true, false);
  }

  @Test
  void aBuildOfSomeCasesIsNoPointOfAnotherCase() {
    built("\"priority\": 0", r -> r);
    String some = built("\"cases\": \"2-3\"", r -> r);
    assertThat(values(history(Activities.MODEL + "&no=5&build=" + beforeNewest()), "buildId"))
        .doesNotContain(some)
        .hasSize(1);
    assertThat(values(history(Activities.MODEL + "&no=2&build=" + some), "buildId")).hasSize(2);
  }

  /** The build before the newest one. */
  private String beforeNewest() {
    return api.get("/api/v1/builds?size=2&activityId=" + activityId)
        .expect(200)
        .json()
        .get("items")
        .get(1)
        .get("id")
        .asString();
  }

  @Test
  void requestsForOtherCasesSayWhatIsWrong() {
    assertThat(api.get(path(Activities.MODEL + "&no=1")).expect(404).text())
        .contains("no result of a test model", "build it first");
    String build = built("\"priority\": 0", r -> r);
    assertThat(api.get(path(Activities.MODEL + "&no=56")).expect(404).text())
        .contains("has no case 56");
    assertThat(api.get(path("Other&no=1&build=" + build)).expect(404).text())
        .contains("the test model 'Other'");
    assertThat(api.get(path(Activities.MODEL + "&no=1&build=none")).expect(404).text())
        .contains("no build 'none'");
    assertThat(api.get(path(Activities.MODEL + "&no=1&by=COMMITS")).expect(404).text())
        .contains("Git source");
    assertThat(api.get(path(Activities.MODEL + "&no=0")).expect(400).text()).contains("from 1");
    assertThat(api.get(path(Activities.MODEL + "&no=1&size=201")).expect(400).text())
        .contains("1 to 200");
    api.get(path(Activities.MODEL + "&no=x")).expect(400);
    api.get(path(Activities.MODEL)).expect(400);
    api.get("/api/v1/activities/none/case-history?model=M&no=1").expect(404);
  }
}
