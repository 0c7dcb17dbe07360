package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.Cancellation;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import tools.jackson.databind.JsonNode;

/** Dispatching of builds to agents, and builds with shards. */
abstract class DispatchStory extends TagStory {
  protected String activityId = "";
  protected String suiteId = "";

  @BeforeEach
  void createSuite() {
    activityId = api.upload(Activities.zip());
    suiteId = api.suite(activityId);
  }

  /** Tests share a server: queued builds of other tests would be dispatched first. */
  @BeforeEach
  @AfterEach
  void cancelRemainingBuilds() {
    api.cancelBuilds();
  }

  @Test
  void dispatchOrderIsPriorityThenLeastActiveActivity() {
    String otherSuite = api.suite(api.upload(Activities.zip()));
    String first = api.build(suiteId);
    String second = api.build(suiteId);
    String other = api.build(otherSuite);
    String urgent = request("\"priority\": 5");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "fair", 3, List.of(), "java")) {
      List<String> order = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        order.add(agent.nextAssignment().getAttempt().getBuildId());
      }
      assertThat(order).containsExactly(urgent, other, first);
      assertThat(build(second).get("waitingFor").asString()).contains("busy");
    }
  }

  @Test
  void buildWaitsForAnAgentWithItsLabelAndToolchain() throws Exception {
    String build = request("\"labels\": [\"real-hardware\"], \"toolchain\": \"17\"");
    try (FakeAgent plain = FakeAgent.register(grpcPort(), "plain", "java")) {
      assertThat(plain.receivesNothingFor(300)).isTrue();
      assertThat(build(build).get("waitingFor").asString())
          .startsWith("no agent offers the label real-hardware");
      try (FakeAgent labelled =
          FakeAgent.register(grpcPort(), "labelled", 1, List.of("real-hardware"), "java")) {
        assertThat(labelled.receivesNothingFor(300)).isTrue();
        assertThat(build(build).get("waitingFor").asString()).startsWith("no agent offers java 17");
      }
    }
    String other = request("\"labels\": [\"real-hardware\"], \"toolchain\": \"test\"");
    try (FakeAgent labelled =
        FakeAgent.register(grpcPort(), "labelled-2", 1, List.of("real-hardware"), "java")) {
      assertThat(labelled.nextAssignment().getAttempt().getBuildId()).isEqualTo(other);
      assertThat(agentNamed("labelled-2").get("labels").get(0).asString())
          .isEqualTo("real-hardware");
    }
    api.post("/api/v1/builds", "{\"suiteId\":\"" + suiteId + "\",\"labels\":[\"no good\"]}")
        .expect(400);
  }

  @Test
  void drainingAgentFinishesAndDisabledAgentLosesItsBuilds() throws Exception {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "drained", "java")) {
      Assignment assignment = agent.nextAssignment();
      TestApplication application = agent.download(assignment);
      setStanding("drained", "DRAINING");
      agent.submit(assignment.getAttempt(), FakeAgent.result(application, List.of()));
      assertThat(build(id).get("state").asString()).isEqualTo("DONE");
      String waiting = api.build(suiteId);
      agent.heartbeat();
      assertThat(agent.receivesNothingFor(300)).isTrue();
      agent.heartbeat();
      await()
          .untilAsserted(
              () -> assertThat(build(waiting).get("waitingFor").asString()).contains("draining"));
      agent.heartbeat();
      setStanding("drained", "ACTIVE");
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      setStanding("drained", "DISABLED");
      Cancellation cancellation = agent.next().getCancellation();
      assertThat(cancellation.getAttempt()).isEqualTo(attempt);
      assertThat(cancellation.getGivenUp()).as("a late result is stored").isTrue();
      assertThat(build(waiting).get("state").asString()).isEqualTo("QUEUED");
      api.delete("/api/v1/agents/drained").expect(409);
    }
    await().until(() -> agentNamed("drained").get("state").asString().equals("OFFLINE"));
    api.delete("/api/v1/agents/drained").expect(204);
    api.delete("/api/v1/agents/drained").expect(404);
  }

  @Test
  void lostAgentsDoNotIncreaseTheRetryDelay() {
    String id =
        api.post("/api/v1/builds", "{\"suiteId\":\"%s\",\"retries\":10}".formatted(suiteId))
            .expect(201)
            .json()
            .get("id")
            .asString();
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "often-lost", "java")) {
      for (int lost = 1; lost <= 9; lost++) {
        AttemptRef attempt = agent.nextAssignment().getAttempt();
        setStanding("often-lost", "DISABLED");
        assertThat(agent.next().getCancellation().getAttempt()).isEqualTo(attempt);
        agent.heartbeat();
        setStanding("often-lost", "ACTIVE");
      }
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      assertThat(attempt.getAttempt()).isEqualTo(10);
      agent.submit(
          attempt,
          BuildFailure.newBuilder()
              .setCategory(BuildFailure.Category.INFRASTRUCTURE)
              .setMessage("no simulator")
              .build());
      Instant failed = Instant.now();
      assertThat(agent.nextAssignment().getAttempt().getBuildId()).isEqualTo(id);
      // After ten reported failures it would be half a minute.
      assertThat(Duration.between(failed, Instant.now())).isLessThan(Duration.ofSeconds(20));
    }
  }

  @Test
  void agentWithFullDiskGetsNoBuilds() throws Exception {
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "full", "java")) {
      agent.heartbeatRefusing("its disk has only 3 MiB left");
      await().until(() -> agentNamed("full").has("refuses"));
      String id = api.build(suiteId);
      assertThat(agent.receivesNothingFor(300)).isTrue();
      assertThat(build(id).get("waitingFor").asString()).contains("3 MiB");
      agent.heartbeat();
      assertThat(agent.nextAssignment().getAttempt().getBuildId()).isEqualTo(id);
    }
  }

  @Test
  void attemptsThatARestartedAgentDoesNotReportAreReassigned() {
    String id = api.build(suiteId);
    FakeAgent before = FakeAgent.register(grpcPort(), "forgetful", "java");
    AttemptRef lost = before.nextAssignment().getAttempt();
    before.close();
    await().until(() -> agentNamed("forgetful").get("state").asString().equals("OFFLINE"));
    try (FakeAgent after = FakeAgent.register(grpcPort(), "forgetful", "java")) {
      // The server sends no cancellation for an unreported attempt; the next message is the new
      // attempt.
      AttemptRef attempt = after.nextAssignment().getAttempt();
      assertThat(attempt.getFencingToken()).isGreaterThan(lost.getFencingToken());
      assertThat(attempt.getBuildId()).isEqualTo(id);
      assertThat(attempt.getAttempt()).isEqualTo(2);
    }
  }

  @Test
  void shardsAreJoinedToOneResult() {
    String id = request("\"shards\": 2");
    assertThat(build(id).get("shards").asInt()).isEqualTo(2);
    try (FakeAgent one = FakeAgent.register(grpcPort(), "shard-one", "java");
        FakeAgent two = FakeAgent.register(grpcPort(), "shard-two", "java")) {
      Assignment first = one.nextAssignment();
      Assignment second = two.nextAssignment();
      TestApplication firstShard = one.download(first);
      TestApplication secondShard = two.download(second);
      assertThat(firstShard.suite().cases().size() + secondShard.suite().cases().size())
          .isEqualTo(55);
      one.reportCases(first.getAttempt(), firstShard.suite().cases().get(0).no());
      api.await(id, b -> b.get("casesDone").asInt() == 1);
      one.appendLog(first.getAttempt(), 0, "log of one\n");
      two.appendLog(second.getAttempt(), 0, "log of two\n");
      one.submit(first.getAttempt(), FakeAgent.result(firstShard, List.of(7)));
      assertThat(build(id).get("state").asString()).isEqualTo("RUNNING");
      two.submit(second.getAttempt(), FakeAgent.result(secondShard, List.of()));
    }
    JsonNode done = api.awaitState(id, "DONE");
    assertThat(done.get("summary").get("total").asInt()).isEqualTo(55);
    JsonNode cases = api.get("/api/v1/builds/" + id + "/result/cases?size=100").json().get("items");
    assertThat(cases)
        .extracting(c -> c.get("no").asInt())
        .containsExactlyElementsOf(java.util.stream.IntStream.rangeClosed(1, 55).boxed().toList());
    await()
        .untilAsserted(
            () ->
                assertThat(api.get("/api/v1/builds/" + id + "/log").text())
                    .contains("== shard 1 of 2\n", "log of one\n", "log of two\n"));
    assertThat(api.get("/api/v1/builds?parentId=" + id).json().get("total").asInt()).isEqualTo(2);
  }

  @Test
  void cancellingABuildCancelsItsShards() {
    String id = request("\"shards\": 3");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "shard-cancel", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      api.post("/api/v1/builds/" + id + "/cancel", "").expect(200);
      assertThat(agent.next().getCancellation().getAttempt()).isEqualTo(attempt);
      await()
          .untilAsserted(
              () ->
                  assertThat(api.get("/api/v1/builds?parentId=" + id).json().get("items"))
                      .allSatisfy(
                          b -> assertThat(b.get("state").asString()).isEqualTo("CANCELLED")));
    }
  }

  protected String request(String options) {
    return api.post("/api/v1/builds", "{\"suiteId\":\"" + suiteId + "\"," + options + "}")
        .expect(201)
        .id();
  }

  protected JsonNode build(String id) {
    return api.get("/api/v1/builds/" + id).expect(200).json();
  }

  private void setStanding(String agent, String standing) {
    api.put(
            "/api/v1/agents/" + agent + "/standing",
            "application/json",
            ("{\"standing\":\"" + standing + "\"}")
                .getBytes(java.nio.charset.StandardCharsets.UTF_8),
            null)
        .expect(200);
  }

  protected JsonNode agentNamed(String name) {
    for (JsonNode agent : api.get("/api/v1/agents").expect(200).json()) {
      if (agent.get("name").asString().equals(name)) {
        return agent;
      }
    }
    throw new AssertionError("no agent " + name);
  }
}
