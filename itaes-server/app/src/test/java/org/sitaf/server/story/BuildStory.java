package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import io.grpc.Status;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.Cancellation;
import org.sitaf.agent.v1.Diagnostic;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestCase;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** Builds from request to result, with a fake agent. Runs with each database. */
abstract class BuildStory extends CaseHistoryStory {
  @Autowired private JdbcClient jdbc;

  @Test
  void buildRunsFromRequestToResult() {
    String id = api.build(suiteId);
    assertThat(build(id).get("state").asString()).isEqualTo("QUEUED");
    assertThat(build(id).get("waitingFor").asString()).startsWith("no agent is connected");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "whole-story", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      assertThat(attempt.getBuildId()).isEqualTo(id);
      assertThat(assignment.getModel()).isEqualTo(Activities.MODEL);
      agent.report(attempt, AttemptState.ATTEMPT_STATE_PREPARING);
      TestApplication application = agent.download(assignment);
      assertThat(application.suite().cases()).hasSize(55);
      agent.report(attempt, AttemptState.ATTEMPT_STATE_COMPILING);
      agent.report(attempt, AttemptState.ATTEMPT_STATE_RUNNING);
      agent.report(attempt, AttemptState.ATTEMPT_STATE_RUNNING);
      agent.reportCases(attempt, 1, 2, 3);
      agent.reportCases(attempt, 3, 4);
      assertThat(build(id).get("casesDone").asInt()).isEqualTo(4);
      assertThat(build(id).get("agent").asString()).isEqualTo("whole-story");
      agent.report(attempt, AttemptState.ATTEMPT_STATE_UPLOADING);
      byte[] document = FakeAgent.result(application, List.of(7));
      assertThat(agent.submit(attempt, document)).isTrue();
      assertThat(agent.submit(attempt, document)).as("again").isTrue();

      JsonNode done = build(id);
      assertThat(done.get("state").asString()).isEqualTo("DONE");
      assertThat(done.get("summary").get("pass").asInt()).isEqualTo(54);
      assertThat(done.get("summary").get("fail").asInt()).isEqualTo(1);
      JsonNode result = api.get("/api/v1/builds/" + id + "/result").expect(200).json();
      assertThat(result.get("summary").get("processingTime").get("max").asDouble()).isEqualTo(55);
      assertThat(result.get("parameters").size()).isEqualTo(3);
      JsonNode failed =
          api.get("/api/v1/builds/" + id + "/result/cases?verdict=FAIL").expect(200).json();
      assertThat(failed.get("total").asInt()).isEqualTo(1);
      assertThat(failed.get("items").get(0).get("no").asInt()).isEqualTo(7);
      assertThat(failed.get("items").get(0).get("actual").get("return").asString())
          .isEqualTo("42.0");
      JsonNode page =
          api.get("/api/v1/builds/" + id + "/result/cases?page=1&size=50").expect(200).json();
      assertThat(page.get("items").size()).isEqualTo(5);
      assertThat(api.get("/api/v1/builds/" + id + "/result/document").expect(200).bytes())
          .isEqualTo(document);
      assertThat(api.get("/api/v1/builds/" + id + "/result/junit").expect(200).text())
          .contains("<testsuite", "ir-sensor", "failures=\"1\"");
      assertThat(api.get("/api/v1/builds/" + id + "/history").expect(200).json())
          .extracting(t -> t.get("state").asString())
          .containsExactly(
              "QUEUED", "LEASED", "PREPARING", "COMPILING", "RUNNING", "UPLOADING", "DONE");
    }
  }

  @Test
  void buildOfSomeCasesExecutesTheseWithTheirNumbers() {
    String id = requestOf("\"cases\": \"12-14, 9, 14-15\"").expect(201).id();
    assertThat(build(id).get("cases").asString()).isEqualTo("9,12-15");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "some-cases", "java")) {
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.getAttempt().getBuildId()).isEqualTo(id);
      TestApplication application = agent.download(assignment);
      assertThat(numbers(application)).containsExactly(9, 12, 13, 14, 15);
      agent.submit(assignment.getAttempt(), FakeAgent.result(application, List.of(9, 13)));
      JsonNode done = api.awaitState(id, "DONE");
      assertThat(done.get("casesTotal").asInt()).isEqualTo(5);
      assertThat(done.get("summary").get("fail").asInt()).isEqualTo(2);
      assertThat(
              api.get("/api/v1/builds/" + id + "/result/cases?verdict=FAIL")
                  .expect(200)
                  .json()
                  .get("items"))
          .extracting(c -> c.get("no").asInt())
          .containsExactly(9, 13);

      String failed = requestOf("\"failedOf\": \"" + id + "\"").expect(201).id();
      assertThat(build(failed).get("cases").asString()).isEqualTo("9,13");
      Assignment again = agent.nextAssignment();
      TestApplication repeated = agent.download(again);
      assertThat(numbers(repeated)).containsExactly(9, 13);
      assertThat(repeated.suite().cases()).isSubsetOf(application.suite().cases());
      agent.submit(again.getAttempt(), FakeAgent.result(repeated, List.of()));
      api.awaitState(failed, "DONE");
      assertThat(requestOf("\"failedOf\": \"" + failed + "\"").expect(409).text())
          .contains("All cases of build " + failed + " passed.");
    }
  }

  @Test
  void shardsOfABuildOfSomeCasesShareThese() {
    String id = requestOf("\"cases\": \"3,20-22\", \"shards\": 2").expect(201).id();
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "some-shards", "java")) {
      List<Integer> executed = new ArrayList<>();
      for (int i = 0; i < 2; i++) {
        Assignment assignment = agent.nextAssignment();
        TestApplication application = agent.download(assignment);
        executed.addAll(numbers(application));
        agent.submit(assignment.getAttempt(), FakeAgent.result(application, List.of(22)));
      }
      assertThat(executed).containsExactlyInAnyOrder(3, 20, 21, 22);
    }
    JsonNode done = api.awaitState(id, "DONE");
    assertThat(done.get("cases").asString()).isEqualTo("3,20-22");
    assertThat(done.get("summary").get("total").asInt()).isEqualTo(4);
    assertThat(done.get("summary").get("fail").asInt()).isEqualTo(1);
  }

  @Test
  void casesThatDoNotExistAreRejected() {
    assertThat(requestOf("\"cases\": \"3,54-56\"").expect(400).text())
        .contains("54-56 does not exist", "55 cases, numbered 1 to 55");
    assertThat(requestOf("\"cases\": \"3;4\"").expect(400).text())
        .contains("expected case numbers such as 9,12-20");
    assertThat(requestOf("\"cases\": \"3\", \"failedOf\": \"x\"").expect(400).text())
        .contains("cannot be given together");
    requestOf("\"failedOf\": \"unknown\"").expect(404);
  }

  private Api.Answer requestOf(String options) {
    return api.post("/api/v1/builds", "{\"suiteId\": \"" + suiteId + "\", " + options + "}");
  }

  private static List<Integer> numbers(TestApplication application) {
    return application.suite().cases().stream().map(TestCase::no).toList();
  }

  @Test
  void suspectResultIsMarkedInAllViews() {
    String id = api.build(suiteId);
    String reason = "a line without number and token (3 times)";
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "honest", "java")) {
      Assignment assignment = agent.nextAssignment();
      byte[] document =
          FakeAgent.result(agent.download(assignment), List.of(), List.of(reason, "a torn line"));
      assertThat(agent.submit(assignment.getAttempt(), document)).isTrue();
    }
    JsonNode build = api.awaitState(id, "DONE");
    assertThat(build.get("suspicions").values())
        .extracting(JsonNode::asString)
        .containsExactly(reason, "a torn line");
    String result = "/api/v1/builds/" + id + "/result";
    assertThat(api.get(result).expect(200).json().get("suspicions").get(0).asString())
        .isEqualTo(reason);
    assertThat(api.get(result + "/junit").expect(200).text())
        .contains("errors=\"1\"", "the result is suspect");
    assertThat(api.get(result + "/report").expect(200).text()).contains("Suspect", reason);
    assertThat(
            api.get("/api/v1/activities/" + build.get("activityId").asString() + "/results")
                .expect(200)
                .json()
                .get("items")
                .get(0)
                .get("suspect")
                .asBoolean())
        .isTrue();
  }

  @Test
  void agentGetsOnlyBuildsForItsToolchains() throws Exception {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "snake", "python")) {
      assertThat(agent.receivesNothingFor(300)).isTrue();
      assertThat(build(id).get("waitingFor").asString()).startsWith("no agent offers java");
    }
  }

  @Test
  void agentGetsNoMoreBuildsThanSlots() throws Exception {
    String first = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "one-slot", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      assertThat(attempt.getBuildId()).isEqualTo(first);
      String second = api.build(suiteId);
      agent.heartbeat(attempt);
      assertThat(agent.receivesNothingFor(300)).isTrue();
      assertThat(build(second).get("waitingFor").asString()).contains("busy");
      agent.submit(attempt, failure(BuildFailure.Category.COMPILATION, "does not compile"));
      assertThat(agent.nextAssignment().getAttempt().getBuildId()).isEqualTo(second);
    }
  }

  @Test
  void compilationFailureIsFinalAndHasALocation() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "compiler", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      BuildFailure failure =
          failure(BuildFailure.Category.COMPILATION, "1 error").toBuilder()
              .addDiagnostics(
                  Diagnostic.newBuilder()
                      .setFile("component/A.java")
                      .setLine(3)
                      .setColumn(9)
                      .setMessage("';' expected"))
              .build();
      assertThat(agent.submit(attempt, failure)).isTrue();
      assertThat(agent.submit(attempt, failure)).as("again").isTrue();
    }
    JsonNode build = build(id);
    assertThat(build.get("state").asString()).isEqualTo("FAILED");
    assertThat(build.get("failure").get("category").asString()).isEqualTo("COMPILATION");
    assertThat(build.get("failure").get("diagnostics").get(0).get("line").asInt()).isEqualTo(3);
    api.get("/api/v1/builds/" + id + "/result").expect(404);
  }

  @Test
  void infrastructureFailureIsRetriedUpToTheLimit() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "unlucky", "java")) {
      long lastToken = 0;
      for (int no = 1; no <= 3; no++) {
        AttemptRef attempt = agent.nextAssignment().getAttempt();
        assertThat(attempt.getAttempt()).isEqualTo(no);
        assertThat(attempt.getFencingToken()).isGreaterThan(lastToken);
        lastToken = attempt.getFencingToken();
        agent.submit(attempt, failure(BuildFailure.Category.INFRASTRUCTURE, "no simulator"));
      }
    }
    JsonNode failed = api.awaitState(id, "FAILED");
    assertThat(failed.get("failure").get("category").asString()).isEqualTo("INFRASTRUCTURE");
  }

  @Test
  void buildOfLostAgentIsReassignedAndLateResultIsIgnored() {
    String id = api.build(suiteId);
    FakeAgent lost = FakeAgent.register(grpcPort(), "lost", "java");
    Assignment first = lost.nextAssignment();
    lost.report(first.getAttempt(), AttemptState.ATTEMPT_STATE_RUNNING);
    // The agent stays connected but sends nothing for a lease.
    api.awaitState(id, "QUEUED");
    try (FakeAgent other = FakeAgent.register(grpcPort(), "other", "java")) {
      Assignment second = other.nextAssignment();
      assertThat(second.getAttempt().getAttempt()).isEqualTo(2);
      TestApplication application = other.download(second);
      byte[] late = FakeAgent.result(application, List.of(1, 2, 3));
      assertRejected(
          Status.Code.FAILED_PRECONDITION,
          () -> lost.report(first.getAttempt(), AttemptState.ATTEMPT_STATE_UPLOADING));
      assertRejected(
          Status.Code.FAILED_PRECONDITION, () -> lost.appendLog(first.getAttempt(), 0, "late"));
      assertRejected(Status.Code.FAILED_PRECONDITION, () -> lost.submit(first.getAttempt(), late));
      other.heartbeat(second.getAttempt());
      assertThat(other.submit(second.getAttempt(), FakeAgent.result(application, List.of())))
          .isTrue();
      assertThat(lost.submit(first.getAttempt(), late)).as("superseded").isFalse();
      assertThat(build(id).get("summary").get("fail").asInt()).isZero();
    } finally {
      lost.close();
    }
  }

  @Test
  void heartbeatsRenewALease() throws Exception {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "alive", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      // For longer than a lease.
      for (int i = 0; i < 28; i++) {
        Thread.sleep(400);
        agent.heartbeat(attempt);
      }
      assertThat(build(id).get("state").asString()).isEqualTo("LEASED");
      assertThat(build(id).get("attempt").asInt()).isEqualTo(1);
    }
  }

  @Test
  void reconnectedAgentContinuesItsAttempt() {
    String id = api.build(suiteId);
    FakeAgent before = FakeAgent.register(grpcPort(), "again", "java");
    Assignment assignment = before.nextAssignment();
    TestApplication application = before.download(assignment);
    before.close();
    try (FakeAgent after = reconnect("again", assignment.getAttempt())) {
      after.report(assignment.getAttempt(), AttemptState.ATTEMPT_STATE_UPLOADING);
      assertThat(after.submit(assignment.getAttempt(), FakeAgent.result(application, List.of())))
          .isTrue();
    }
    assertThat(build(id).get("attempt").asInt()).isEqualTo(1);
  }

  @Test
  void cancelledBuildStopsItsAgentAndAcceptsNoResult() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "stopped", "java")) {
      Assignment assignment = agent.nextAssignment();
      TestApplication application = agent.download(assignment);
      agent.report(assignment.getAttempt(), AttemptState.ATTEMPT_STATE_RUNNING);
      api.post("/api/v1/builds/" + id + "/cancel", "").expect(200);
      Cancellation cancellation = agent.next().getCancellation();
      assertThat(cancellation.getAttempt()).isEqualTo(assignment.getAttempt());
      assertThat(cancellation.getGivenUp()).isFalse();
      assertRejected(
          Status.Code.FAILED_PRECONDITION,
          () -> agent.submit(assignment.getAttempt(), FakeAgent.result(application, List.of())));
      assertThat(build(id).get("state").asString()).isEqualTo("CANCELLED");
      assertThat(
              agent.submit(
                  assignment.getAttempt(), failure(BuildFailure.Category.CANCELLED, "stopped")))
          .isTrue();
      String next = api.build(suiteId);
      assertThat(agent.nextAssignment().getAttempt().getBuildId()).isEqualTo(next);
    }
    api.post("/api/v1/builds/" + id + "/cancel", "").expect(409);
  }

  @Test
  void logIsAppendedByOffsetAndTruncatedAtTheLimit() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "logger", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      assertThat(agent.appendLog(attempt, 0, "hello ")).isEqualTo(6);
      assertThat(agent.appendLog(attempt, 0, "hello world")).isEqualTo(11);
      assertThat(agent.appendLog(attempt, 0, "hello")).as("sent again").isEqualTo(11);
      assertRejected(Status.Code.OUT_OF_RANGE, () -> agent.appendLog(attempt, 12, "gap"));
      var answer = api.get("/api/v1/builds/" + id + "/log?offset=6").expect(200);
      assertThat(answer.text()).isEqualTo("world");
      assertThat(answer.headers().firstValue("Sitaf-Log-End")).contains("11");
      String much = "x".repeat(60 << 10);
      assertThat(agent.appendLog(attempt, 11, much)).isEqualTo(11 + much.length());
      agent.appendLog(attempt, 11 + much.length(), much);
      assertThat(api.get("/api/v1/builds/" + id + "/log").expect(200).text())
          .hasSizeBetween(64 << 10, (64 << 10) + 200)
          .endsWith("[log truncated: it exceeds the limit of this server]\n");
    }
  }

  @Test
  void logsAreStoredInTheDatabase() {
    String activity = api.upload(Activities.zip());
    String id = api.build(api.suite(activity));
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "log-sharer", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      assertThat(attempt.getBuildId()).isEqualTo(id);
      agent.appendLog(attempt, 0, "one\n");
      agent.appendLog(attempt, 4, "two\n");
    }
    assertThat(chunks(id)).isEqualTo(2);
    assertThat(api.get("/api/v1/builds/" + id + "/log?offset=2").text()).isEqualTo("e\ntwo\n");
    api.post("/api/v1/builds/" + id + "/cancel", "").expect(200);
    api.delete("/api/v1/activities/" + activity).expect(204);
    assertThat(chunks(id)).isZero();
  }

  private int chunks(String buildId) {
    return jdbc.sql("SELECT COUNT(*) FROM build_log WHERE build_id = ?")
        .param(buildId)
        .query(Integer.class)
        .single();
  }

  @Test
  void deletedResultIsNotCached() {
    String activity = api.upload(Activities.zip());
    String id = api.build(api.suite(activity));
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "deleted", "java")) {
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.getAttempt().getBuildId()).isEqualTo(id);
      agent.submit(
          assignment.getAttempt(), FakeAgent.result(agent.download(assignment), List.of()));
    }
    String csv = "/api/v1/builds/" + id + "/result/cases.csv";
    api.get(csv).expect(200);
    api.delete("/api/v1/activities/" + activity).expect(204);
    api.get(csv).expect(404);
  }

  @Test
  void protocolViolationsAreRejected() throws Exception {
    api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "strict", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      byte[] document = FakeAgent.result(agent.download(assignment), List.of());
      AttemptRef forged =
          attempt.toBuilder().setFencingToken(attempt.getFencingToken() + 1).build();
      assertRejected(Status.Code.FAILED_PRECONDITION, () -> agent.submit(forged, document));
      assertRejected(
          Status.Code.INVALID_ARGUMENT, () -> agent.submit(attempt, document, "0".repeat(64)));
      assertRejected(Status.Code.INVALID_ARGUMENT, () -> agent.submit(attempt, new byte[] {'<'}));
      assertRejected(Status.Code.NOT_FOUND, () -> agent.download(attempt, "0".repeat(64)));
      assertRejected(
          Status.Code.INVALID_ARGUMENT,
          () -> agent.report(attempt, AttemptState.ATTEMPT_STATE_UNSPECIFIED));
      agent.report(attempt, AttemptState.ATTEMPT_STATE_RUNNING);
      assertRejected(
          Status.Code.INVALID_ARGUMENT,
          () -> agent.report(attempt, AttemptState.ATTEMPT_STATE_COMPILING));
      try (FakeAgent duplicate = FakeAgent.dial(grpcPort())) {
        duplicate.sendRegister("strict", "java");
        assertThat(Status.fromThrowable(duplicate.end()).getCode())
            .isEqualTo(Status.Code.ALREADY_EXISTS);
      }
      try (FakeAgent nameless = FakeAgent.dial(grpcPort())) {
        nameless.sendRegister("no good name", "java");
        assertThat(Status.fromThrowable(nameless.end()).getCode())
            .isEqualTo(Status.Code.INVALID_ARGUMENT);
      }
    }
  }

  @Test
  void activityWithRunningBuildIsNotDeleted() {
    String id = api.build(suiteId);
    assertThat(api.delete("/api/v1/activities/" + activityId).expect(409).text()).contains(id);
    api.post("/api/v1/builds/" + id + "/cancel", "").expect(200);
    api.delete("/api/v1/activities/" + activityId).expect(204);
    api.get("/api/v1/builds/" + id).expect(404);
    api.get("/api/v1/suites/" + suiteId).expect(404);
  }

  @Test
  void agentsAreListedWithTheirState() {
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "listed", "java")) {
      agent.heartbeat();
      assertThat(agentNamed("listed").get("state").asString()).isEqualTo("ONLINE");
    }
    org.awaitility.Awaitility.await()
        .until(() -> agentNamed("listed").get("state").asString().equals("OFFLINE"));
  }

  /** The server may take a moment to detect that the former connection was closed. */
  private FakeAgent reconnect(String name, AttemptRef running) {
    return org.awaitility.Awaitility.await()
        .ignoreExceptionsMatching(AssertionError.class::isInstance)
        .until(() -> FakeAgent.register(grpcPort(), name, "java", running), a -> true);
  }

  private static BuildFailure failure(BuildFailure.Category category, String message) {
    return BuildFailure.newBuilder().setCategory(category).setMessage(message).build();
  }
}
