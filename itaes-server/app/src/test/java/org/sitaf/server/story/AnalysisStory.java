package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.AnalysisOrder;
import org.sitaf.agent.v1.AnalysisReport;
import org.sitaf.agent.v1.ApplicationFile;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.ExplainedCause;
import org.sitaf.agent.v1.Explanation;
import org.sitaf.agent.v1.FlakyCase;
import org.sitaf.agent.v1.MutationScore;
import org.sitaf.agent.v1.NamedLiteral;
import org.sitaf.agent.v1.Repetition;
import org.sitaf.agent.v1.Score;
import org.sitaf.agent.v1.SurvivingFault;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestCase;
import org.sitaf.server.support.FakeAgent;
import tools.jackson.databind.JsonNode;

/** Explanations, scores and repetitions of builds, from the request to the report. */
abstract class AnalysisStory extends SignalStory {
  private static final String BUILDS = "/api/v1/builds/";

  /** A build that has ended with these failed cases. */
  private byte[] finished(FakeAgent agent, String id, List<Integer> failing) {
    Assignment assignment = agent.nextAssignment();
    assertThat(assignment.getAttempt().getBuildId()).isEqualTo(id);
    assertThat(assignment.hasAnalysis()).isFalse();
    byte[] document = FakeAgent.result(agent.download(assignment), failing);
    agent.submit(assignment.getAttempt(), document);
    api.awaitState(id, "DONE");
    return document;
  }

  private static AnalysisReport explanation(TestApplication application, int caseNo) {
    TestCase failed = application.suite().cases().get(caseNo - 1);
    ExplainedCause.Builder cause =
        ExplainedCause.newBuilder().setVerdict("FAIL").setMessage("a wrong value").addCases(caseNo);
    for (int i = 0; i < failed.values().size(); i++) {
      NamedLiteral value =
          NamedLiteral.newBuilder()
              .setName(application.model().inputs().get(i).name())
              .setLiteral(failed.values().get(i))
              .build();
      cause.addSimplest(value);
      if (i == 0) {
        cause.addParameters(value);
      }
    }
    cause.addRecord(NamedLiteral.newBuilder().setName("verdict").setLiteral("FAIL"));
    return AnalysisReport.newBuilder()
        .setExplanation(Explanation.newBuilder().addCauses(cause).setExecutions(3))
        .build();
  }

  @Test
  void failuresAreExplainedByAnAgent() throws Exception {
    String id = api.build(suiteId);
    List<String> expected;
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "explains", "java")) {
      byte[] document = finished(agent, id, List.of(7));
      api.get(BUILDS + id + "/explanation").expect(204);

      String analysis = api.post(BUILDS + id + "/explanation", "").expect(201).id();
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      assertThat(attempt.getBuildId()).isEqualTo(analysis);
      assertThat(assignment.getAnalysis().getKind()).isEqualTo(AnalysisOrder.Kind.EXPLANATION);
      assertThat(assignment.getAnalysis().getMaxCases()).isEqualTo(500);
      ApplicationFile analysed =
          assignment.getFilesList().stream()
              .filter(f -> f.getPath().equals("analysed-result.xml"))
              .findFirst()
              .orElseThrow();
      assertThat(agent.download(attempt, analysed.getSha256())).isEqualTo(document);
      TestApplication application = agent.download(assignment);
      assertThat(api.post(BUILDS + id + "/explanation", "").expect(409).text())
          .contains("An analysis of build " + id + " is");
      agent.reportCases(attempt, 1, 2);
      assertThat(explanation(id).get("executed").asInt()).isEqualTo(2);
      assertThatThrownBy(() -> agent.submit(attempt, document))
          .isInstanceOfSatisfying(
              StatusRuntimeException.class,
              e -> assertThat(e.getStatus().getCode()).isEqualTo(Status.Code.INVALID_ARGUMENT));
      assertThatThrownBy(() -> agent.submit(attempt, score()))
          .hasMessageContaining("is of the kind SCORE");

      AnalysisReport report = explanation(application, 7);
      assertThat(agent.submit(attempt, report)).isTrue();
      assertThat(agent.submit(attempt, report)).as("again").isTrue();
      JsonNode cause = explanation(id).get("explanation").get("causes").get(0);
      assertThat(cause.get("sentence").asString())
          .startsWith("fails where `")
          .endsWith(", whatever the rest");
      assertThat(cause.get("cases").get(0).asInt()).isEqualTo(7);
      assertThat(api.get("/api/v1/builds?size=200").expect(200).text())
          .contains(id)
          .doesNotContain(analysis);

      assertThat(api.get(BUILDS + id + "/explanation/causes/1/bundle").expect(200).bytes())
          .startsWith('P', 'K');
      api.get(BUILDS + id + "/explanation/causes/2/bundle").expect(404);
      expected = application.suite().cases().get(6).values();
    }
    // No agent is connected now that could take the build and disconnect.
    String simplest = api.post(BUILDS + id + "/explanation/causes/1/run", "").expect(201).id();
    assertThat(build(simplest).get("cases").asString()).isEqualTo("56");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "runs-simplest", "java")) {
      Assignment assignment = agent.nextAssignment();
      TestApplication alone = agent.download(assignment);
      assertThat(alone.suite().cases())
          .singleElement()
          .satisfies(
              c -> {
                assertThat(c.no()).isEqualTo(56);
                assertThat(c.values()).isEqualTo(expected);
              });
      agent.submit(assignment.getAttempt(), FakeAgent.result(alone, List.of(56)));
    }
  }

  @Test
  void aCancelledExplanationIsRequestedAgain() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "explains-again", "java")) {
      finished(agent, id, List.of(3));
      String analysis = api.post(BUILDS + id + "/explanation", "").expect(201).id();
      agent.nextAssignment();
      api.post(BUILDS + analysis + "/cancel", "").expect(200);
      assertThat(agent.next().hasCancellation()).isTrue();
      assertThat(explanation(id).get("state").asString()).isEqualTo("CANCELLED");
      String again = api.post(BUILDS + id + "/explanation", "").expect(201).id();
      assertThat(explanation(id).get("id").asString()).isEqualTo(again).isNotEqualTo(analysis);
      api.post(BUILDS + again + "/cancel", "").expect(200);
    }
  }

  @Test
  void onlyFailuresAreExplained() {
    String body = "{\"suiteId\": \"" + suiteId + "\", \"explain\": true}";
    String passing = api.post("/api/v1/builds", body).expect(201).id();
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "explains-failures", "java")) {
      finished(agent, passing, List.of());
      api.get(BUILDS + passing + "/explanation").expect(204);
      assertThat(api.post(BUILDS + passing + "/explanation", "").expect(409).text())
          .contains("No case of build " + passing + " failed.");

      String failing = api.post("/api/v1/builds", body).expect(201).id();
      finished(agent, failing, List.of(3));
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.hasAnalysis()).isTrue();
      assertThat(explanation(failing).get("id").asString())
          .isEqualTo(assignment.getAttempt().getBuildId());
      api.post(BUILDS + assignment.getAttempt().getBuildId() + "/cancel", "").expect(200);
    }
  }

  @Test
  void theSpecificationOfABuildIsScored() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "scores", "java")) {
      finished(agent, id, List.of());
      api.post(BUILDS + id + "/score", "").expect(201);
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.getAnalysis().getKind()).isEqualTo(AnalysisOrder.Kind.SCORE);
      agent.submit(assignment.getAttempt(), score());
      JsonNode scored = api.get(BUILDS + id + "/score").expect(200).json();
      assertThat(scored.get("state").asString()).isEqualTo("DONE");
      assertThat(scored.get("score").get("survivors").get(0).get("suggestion").asString())
          .isEqualTo("expect a value");
      JsonNode mutations = scored.get("score").get("mutations");
      assertThat(mutations.get("made").asInt()).isEqualTo(3);
      assertThat(mutations.get("survivors").get(0).get("where").asString())
          .isEqualTo("component/Arm.java:12");
      assertThat(mutations.get("unchanged").get(0).asString()).endsWith("call of close left out");
    }
  }

  @Test
  void theCasesOfABuildAreRepeated() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "repeats", "java")) {
      byte[] document = finished(agent, id, List.of(3));
      api.get(BUILDS + id + "/repetition").expect(204);
      assertThat(api.post(BUILDS + id + "/repetition", "{\"runs\": 101}").expect(400).text())
          .contains("runs: must be 1 to 100, but is 101.");
      api.post(BUILDS + id + "/repetition", "{\"runs\": 3}").expect(201);
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.getAnalysis().getKind()).isEqualTo(AnalysisOrder.Kind.REPETITION);
      assertThat(assignment.getAnalysis().getMaxCases()).isEqualTo(3 * 55);
      String sha256 =
          assignment.getFilesList().stream()
              .filter(f -> f.getPath().equals("analysed-result.xml"))
              .findFirst()
              .orElseThrow()
              .getSha256();
      assertThat(agent.download(assignment.getAttempt(), sha256)).isEqualTo(document);
      assertThatThrownBy(
              () ->
                  agent.submit(
                      assignment.getAttempt(), repetition(FlakyCase.Cause.CAUSE_UNSPECIFIED)))
          .hasMessageContaining("repetition.cases.cause: must be COMPONENT");
      agent.submit(assignment.getAttempt(), repetition(FlakyCase.Cause.COMPONENT));

      JsonNode found = api.get(BUILDS + id + "/repetition").expect(200).json().get("repetition");
      assertThat(found.get("runs").asInt()).isEqualTo(3);
      assertThat(found.get("count").asInt()).isEqualTo(1);
      JsonNode flaky = found.get("cases").get(0);
      assertThat(flaky.get("cause").asString()).isEqualTo("COMPONENT");
      assertThat(flaky.get("verdicts").get(0).asString()).isEqualTo("FAIL");
      assertThat(flaky.get("verdicts")).hasSize(4);
    }
  }

  private static AnalysisReport repetition(FlakyCase.Cause cause) {
    return AnalysisReport.newBuilder()
        .setRepetition(
            Repetition.newBuilder()
                .setRuns(3)
                .setCount(1)
                .addCases(
                    FlakyCase.newBuilder()
                        .setNo(3)
                        .setCause(cause)
                        .addAllVerdicts(List.of("FAIL", "PASS", "PASS", "FAIL"))
                        .setReason("its inputs are equal, and what it returns differs")))
        .build();
  }

  private static AnalysisReport score() {
    return AnalysisReport.newBuilder()
        .setScore(
            Score.newBuilder()
                .setInjected(5)
                .setNoticed(4)
                .setMutations(
                    MutationScore.newBuilder()
                        .setMade(3)
                        .setNoticed(1)
                        .addSurvivors(
                            SurvivingFault.newBuilder()
                                .setFault("component/Arm.java:12: < replaced by <=")
                                .setWhere("component/Arm.java:12"))
                        .addUnchanged("component/Arm.java:20: call of close left out"))
                .addSurvivors(
                    SurvivingFault.newBuilder()
                        .setFault("return: sign")
                        .setWhere("return")
                        .setSuggestion("expect a value")))
        .build();
  }

  private JsonNode explanation(String id) {
    return api.get(BUILDS + id + "/explanation").expect(200).json();
  }
}
