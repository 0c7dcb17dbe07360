package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.server.result.Results;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** Two builds are compared by the values of their results; builds know their commits. */
@Tag("slow")
class ValueComparisonStoryTest extends ServerTest {
  private static final String LABELS = "\"buildLabels\": {\"branch\": \"main\", \"run\": \"7=8\"}";

  @BeforeEach
  @AfterEach
  void cancelRemainingBuilds() {
    for (JsonNode build : get("/api/v1/builds?size=500").get("items")) {
      if (!build.has("finished")) {
        api.post("/api/v1/builds/" + build.get("id").asString() + "/cancel", "");
      }
    }
  }

  /** Builds a suite with an agent of its own. */
  private String build(String suite, String options, UnaryOperator<CaseResult> change) {
    String id =
        api.post("/api/v1/builds", "{\"suiteId\":\"" + suite + "\"" + options + "}")
            .expect(201)
            .id();
    ScheduledExecutorService heart = Executors.newSingleThreadScheduledExecutor();
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "compared", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      assertThat(attempt.getBuildId()).isEqualTo(id);
      // The lease of the tests is short for a busy machine.
      heart.scheduleAtFixedRate(() -> agent.heartbeat(attempt), 0, 300, TimeUnit.MILLISECONDS);
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
      assertThat(agent.submit(attempt, document.toByteArray())).isTrue();
    } finally {
      heart.shutdownNow();
    }
    return id;
  }

  private static CaseResult with(CaseResult result, Verdict verdict, String value, String message) {
    return new CaseResult(
        result.no(),
        verdict,
        result.values(),
        result.expected(),
        value.isEmpty() ? List.of() : List.of(new NamedValue("", value)),
        verdict == Verdict.ERROR ? null : result.time(),
        message);
  }

  private static CaseResult changed(CaseResult result) {
    return switch (result.no()) {
      case 2, 3 -> with(result, Verdict.FAIL, "7.25", "expected another value");
      case 5 -> with(result, Verdict.ERROR, "", "java.lang.IllegalStateException: no beam");
      default -> result;
    };
  }

  private JsonNode get(String path) {
    return api.get(path).expect(200).json();
  }

  @Test
  void valuesOfTwoBuildsAreComparedInGroups() {
    String suite = api.suite(api.upload(Activities.zip()));
    String base = build(suite, "", result -> result);
    String now = build(suite, "", ValueComparisonStoryTest::changed);
    String path = "/api/v1/builds/" + now + "/result/comparison";
    JsonNode values = get(path + "/values?with=" + base);
    assertThat(values.get("cases").asInt()).isEqualTo(55);
    assertThat(values.get("differingCases").asInt()).isEqualTo(3);
    assertThat(values.get("differences").asInt()).isEqualTo(3);
    assertThat(values.get("lastBits").asInt()).isZero();
    assertThat(values.get("notComparable").asInt()).isZero();
    assertThat(values.get("base").get("agent").asString()).isEqualTo("fake agent");
    assertThat(values.get("groups"))
        .extracting(g -> g.get("kind").asString() + " " + g.get("size").asInt())
        .as("the largest last")
        .containsExactly("error 1", "value 2");
    assertThat(values.get("groups").get(0).get("text").asString())
        .startsWith("1 × IllegalStateException in NEW only");

    JsonNode group = get(path + "/differences?group=1&size=1&page=1&with=" + base);
    assertThat(group.get("total").asInt()).isEqualTo(2);
    JsonNode second = group.get("items").get(0);
    assertThat(second.get("no").asInt()).isEqualTo(3);
    assertThat(second.get("output").asString()).isEqualTo("return");
    assertThat(second.get("now").asString()).isEqualTo("7.25");
    assertThat(second.get("base").asString()).isNotEmpty().isNotEqualTo("7.25");
    assertThat(second.get("inputs").size()).isEqualTo(values.get("parameters").size());
    assertThat(get(path + "/differences?with=" + base).get("total").asInt()).isEqualTo(3);
    assertThat(get(path + "/differences?part=lastBits&with=" + base).get("total").asInt()).isZero();
    assertThat(get(path + "/not-comparable?with=" + base).get("total").asInt()).isZero();

    api.get(path + "/differences?group=2&with=" + base).expect(404);
    api.get(path + "/differences?group=0&part=slower&with=" + base).expect(400);
    api.get(path + "/values?with=none").expect(404);
    api.get("/api/v1/builds/none/result/comparison/values?with=" + base).expect(404);
  }

  @Test
  void equalResultsHaveNoDifferences() {
    String suite = api.suite(api.upload(Activities.zip()));
    String base = build(suite, "", ValueComparisonStoryTest::changed);
    String now = build(suite, "", ValueComparisonStoryTest::changed);
    JsonNode values = get("/api/v1/builds/" + now + "/result/comparison/values?with=" + base);
    assertThat(values.get("cases").asInt()).isEqualTo(55);
    assertThat(values.get("differences").asInt()).isZero();
    assertThat(values.get("groups").size()).isZero();
  }

  @Test
  void aBuildKnowsItsCommitAndLabels() {
    String activity = api.upload(Activities.zip());
    String suite = api.suite(activity);
    String known = build(suite, ", \"commit\": \"abc123-dirty\", " + LABELS, result -> result);
    String unknown = build(suite, "", result -> result);
    JsonNode build = get("/api/v1/builds/" + known);
    assertThat(build.get("commit").asString()).isEqualTo("abc123-dirty");
    assertThat(build.get("buildLabels").get("run").asString()).isEqualTo("7=8");
    assertThat(get("/api/v1/builds/" + unknown).has("commit")).isFalse();
    JsonNode ofCommit = get("/api/v1/builds?commit=abc123-dirty&activityId=" + activity);
    assertThat(ofCommit.get("items"))
        .extracting(b -> b.get("id").asString())
        .containsExactly(known);
    JsonNode results = get("/api/v1/activities/" + activity + "/results").get("items");
    assertThat(results.get(1).get("commit").asString()).isEqualTo("abc123-dirty");
    assertThat(results.get(0).has("commit")).isFalse();
  }

  @Test
  void unusualCommitsAndLabelsAreRefused() {
    String suite = api.suite(api.upload(Activities.zip()));
    for (String option :
        List.of(
            "\"commit\": \"a b\"",
            "\"commit\": \"-x\"",
            "\"buildLabels\": {\"a=b\": \"x\"}",
            "\"buildLabels\": {\"a\": \"x\\ny\"}",
            "\"buildLabels\": {\"a\": null}")) {
      api.post("/api/v1/builds", "{\"suiteId\":\"" + suite + "\"," + option + "}").expect(400);
    }
  }
}
