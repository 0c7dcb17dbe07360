package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.agent.v1.OutputValue;
import org.sitaf.agent.v1.ProcessingTime;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.server.result.Results;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** The live view of a running build, and logs, coverage and filters afterwards. */
@Tag("slow")
class WatchingStoryTest extends ServerTest {
  private static final String SOURCE = "component/org/sitaf/examples/ir/InfraredSensor.java";

  private String suiteId = "";

  @BeforeEach
  void uploadAnActivity() {
    suiteId = api.suite(api.upload(Activities.zip()));
  }

  @AfterEach
  void cancelRemainingBuilds() {
    api.cancelBuilds();
  }

  @Test
  void finishedCasesAreListedUntilTheResultIsAccepted() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "watched", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      agent.report(attempt, AttemptState.ATTEMPT_STATE_RUNNING);
      assertThat(live(id, "").get("total").asInt()).isZero();
      agent.reportOutcomes(attempt, outcome(2, "PASS"), outcome(1, "FAIL"));
      agent.reportOutcomes(attempt, outcome(1, "FAIL"), outcome(3, "PASS"));
      JsonNode cases = live(id, "");
      assertThat(cases.get("total").asInt()).as("a repeated case counts once").isEqualTo(3);
      assertThat(cases.get("items"))
          .extracting(c -> c.get("no").asInt())
          .as("in the order in which they finished")
          .containsExactly(2, 1, 3);
      JsonNode second = live(id, "?page=1&size=1").get("items").get(0);
      assertThat(second.get("verdict").asString()).isEqualTo("FAIL");
      assertThat(second.get("values").get(1).asString()).isEqualTo("4");
      assertThat(second.get("expected").get("return").asString()).isEqualTo("5.0");
      assertThat(second.get("actual").get("return").asString()).isEqualTo("<b>6.0");
      assertThat(second.get("processingTimeUs").asDouble()).isEqualTo(12.5);
      assertThat(second.get("message").asString()).hasSize(1002).startsWith("xxx");

      agent.submit(attempt, FakeAgent.result(agent.download(assignment), List.of()));
      assertThat(live(id, "").get("total").asInt()).as("the result was accepted").isZero();
    }
    api.get("/api/v1/builds/none/cases").expect(404);
  }

  @Test
  void cancelledBuildKeepsItsFinishedCases() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "cut-short", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      agent.report(attempt, AttemptState.ATTEMPT_STATE_RUNNING);
      agent.reportOutcomes(attempt, outcome(1, "PASS"));
      api.post("/api/v1/builds/" + id + "/cancel", "").expect(200);
    }
    assertThat(live(id, "").get("total").asInt()).isEqualTo(1);
  }

  @Test
  void caseLogContainsTheOutputOfTheCase() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "talker", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      agent.appendLog(
          attempt,
          0,
          """
          [sitaf] sandbox: none
          hello
          [sitaf] case 7
          seven
          [sitaf] a remark
          and [sitaf] case 8 too
          [sitaf] case 8
          eight
          [sitaf] case 7
          seven again
          [sitaf] outside of cases
          goodbye
          [sitaf] case 7: no answer within 10 s
          """);
    }
    assertThat(api.get("/api/v1/builds/" + id + "/cases/7/log").expect(200).text())
        .isEqualTo(
            """
            seven
            and [sitaf] case 8 too
            seven again
            [sitaf] case 7: no answer within 10 s
            """);
    assertThat(api.get("/api/v1/builds/" + id + "/cases/8/log").expect(200).text())
        .isEqualTo("eight\n");
    assertThat(api.get("/api/v1/builds/" + id + "/cases/9/log").expect(200).text()).isEmpty();
    api.get("/api/v1/builds/none/cases/1/log").expect(404);
  }

  @Test
  void coverageIsAvailableByFileAndLine() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "covering", "java")) {
      Assignment assignment = agent.nextAssignment();
      TestApplication application = agent.download(assignment);
      TestResult result =
          Results.read(FakeAgent.result(application, List.of()))
              .with(
                  new Coverage(
                      List.of(
                          new Coverage.File(
                              SOURCE,
                              List.of(
                                  new Coverage.Line(9, true, 4, 3),
                                  new Coverage.Line(12, false, 0, 0))))));
      ByteArrayOutputStream document = new ByteArrayOutputStream();
      TestResultXml.write(result, document);
      assertThat(agent.submit(assignment.getAttempt(), document.toByteArray())).isTrue();
    }
    String path = "/api/v1/builds/" + id + "/result/coverage";
    JsonNode coverage = api.get(path).expect(200).json();
    assertThat(coverage.get("measured").asBoolean()).isTrue();
    assertThat(coverage.get("statement").asDouble()).isEqualTo(50);
    assertThat(coverage.get("branch").asDouble()).isEqualTo(75);
    assertThat(coverage.get("files").get(0).get("reached").asInt()).isEqualTo(1);
    JsonNode source = api.get(path + "/source?path=" + SOURCE).expect(200).json();
    assertThat(source.get("source").asString())
        .isEqualTo(
            new String(Activities.files().get(SOURCE), java.nio.charset.StandardCharsets.UTF_8));
    assertThat(source.get("lines").get(1).get("reached").asBoolean()).isFalse();
    api.get(path + "/source?path=activity.yaml").expect(404);
  }

  @Test
  void resultWithoutCoverageIsNotMeasured() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "not-covering", "java")) {
      Assignment assignment = agent.nextAssignment();
      agent.submit(
          assignment.getAttempt(), FakeAgent.result(agent.download(assignment), List.of()));
    }
    JsonNode coverage = api.get("/api/v1/builds/" + id + "/result/coverage").expect(200).json();
    assertThat(coverage.get("measured").asBoolean()).isFalse();
    assertThat(coverage.get("files")).isEmpty();
  }

  @Test
  void casesAreFilteredByVerdictAndNumericValue() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "filtering", "java")) {
      Assignment assignment = agent.nextAssignment();
      agent.submit(
          assignment.getAttempt(), FakeAgent.result(agent.download(assignment), List.of(2)));
    }
    String path = "/api/v1/builds/" + id + "/result/cases?parameter=Distance&value=";
    int as = api.get(path + "5.0").expect(200).json().get("total").asInt();
    assertThat(as).isPositive();
    assertThat(api.get(path + "5").expect(200).json().get("total").asInt()).isEqualTo(as);
    JsonNode failed = api.get(path + "5&verdict=FAIL").expect(200).json();
    assertThat(failed.get("items")).extracting(c -> c.get("no").asInt()).containsExactly(2);
    assertThat(api.get(path + "far").expect(200).json().get("total").asInt()).isZero();
  }

  private JsonNode live(String id, String query) {
    return api.get("/api/v1/builds/" + id + "/cases" + query).expect(200).json();
  }

  private static CaseOutcome outcome(int no, String verdict) {
    return CaseOutcome.newBuilder()
        .setNo(no)
        .setVerdict(verdict)
        .addValues("1")
        .addValues("4")
        .addValues("5.0")
        .addExpected(OutputValue.newBuilder().setLiteral("5.0"))
        .addActual(OutputValue.newBuilder().setLiteral("<b>6.0"))
        .setProcessingTime(ProcessingTime.newBuilder().setTotal(12.5))
        .setMessage("x".repeat(5000))
        .build();
  }
}
