package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** Builds that use real devices. */
class DeviceStoryTest extends ServerTest {
  private static final String HARDWARE =
      """
      hardware:
        ir1: {backend: provider, max_age_s: 1}
        ir2: {backend: shadow}
        ir3: {backend: sim}
      """;

  private String suiteId = "";

  @BeforeEach
  void createSuite() {
    suiteId = suite(HARDWARE);
  }

  private String suite(String hardware) {
    Map<String, byte[]> files = new HashMap<>(Activities.files());
    String profile = new String(files.get("activity.yaml"), StandardCharsets.UTF_8);
    files.put("activity.yaml", (profile + hardware).getBytes(StandardCharsets.UTF_8));
    return api.suite(api.upload(Activities.zip(files)));
  }

  /** Tests share a server: queued builds of other tests would be dispatched first. */
  @BeforeEach
  @AfterEach
  void cancelRemainingBuilds() {
    api.cancelBuilds();
  }

  @Test
  void aBuildWithRealDevicesNeedsTheRoleOperator() {
    String body = "{\"suiteId\":\"" + suiteId + "\"}";
    Api.Answer refused = new Api(httpPort(), tokenOf("TESTER")).post("/api/v1/builds", body);
    assertThat(refused.expect(403).text()).contains("role OPERATOR", "(ir1, ir2)");
    new Api(httpPort(), tokenOf("OPERATOR")).post("/api/v1/builds", body).expect(201);
    assertThat(request("\"shards\":2").expect(400).text()).contains("shards: must be 1");
    assertThat(request("\"explain\":true").expect(400).text()).contains("explain: must be false");
  }

  @Test
  void aScheduleCannotUseRealDevicesUnlessAnOperatorRunsItNow() {
    String schedule =
        api.post(
                "/api/v1/schedules",
                "{\"suiteId\":\"%s\",\"at\":\"2099-01-01T00:00:00Z\"}".formatted(suiteId))
            .expect(201)
            .id();
    String path = "/api/v1/schedules/" + schedule + "/run";
    JsonNode refused =
        build(
            new Api(httpPort(), tokenOf("TESTER"))
                .post(path, "")
                .expect(200)
                .json()
                .get("buildId")
                .asString());
    assertThat(refused.get("state").asString()).isEqualTo("FAILED");
    assertThat(refused.toString()).contains("role OPERATOR");
    JsonNode allowed =
        build(
            new Api(httpPort(), tokenOf("OPERATOR"))
                .post(path, "")
                .expect(200)
                .json()
                .get("buildId")
                .asString());
    assertThat(allowed.get("state").asString()).isEqualTo("QUEUED");
    api.delete("/api/v1/schedules/" + schedule).expect(204);
  }

  @Test
  void aBuildHasItsDevicesAloneAndOthersDoNotWaitForIt() throws Exception {
    String first = requested();
    try (FakeAgent agent =
        FakeAgent.offering(grpcPort(), "bench", 2, List.of("ir1", "ir2", "ir7"))) {
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.getAttempt().getBuildId()).isEqualTo(first);
      assertThat(assignment.getDevicesList()).containsExactlyInAnyOrder("ir1", "ir2");
      String second = requested();
      assertThat(agent.receivesNothingFor(300)).isTrue();
      assertThat(build(second).get("waitingFor").asString())
          .isEqualTo("another build uses one of the devices ir1, ir2");
      // Neither one without devices nor one with a free device waits for it.
      String simulated = api.build(api.suite(api.upload(Activities.zip())));
      Assignment other = agent.nextAssignment();
      assertThat(other.getAttempt().getBuildId()).isEqualTo(simulated);
      submit(agent, other);
      String free = api.build(suite("hardware: {ir7: {backend: provider}}\n"));
      other = agent.nextAssignment();
      assertThat(other.getAttempt().getBuildId()).isEqualTo(free);
      submit(agent, other);
      submit(agent, assignment);
      assertThat(agent.nextAssignment().getAttempt().getBuildId()).isEqualTo(second);
      api.post("/api/v1/builds/" + first + "/explanation", "").expect(409);
      assertThat(agentNamed("bench").get("devices")).hasSize(3);
    }
  }

  @Test
  void aReconnectedAgentStillHasItsDevicesInUse() throws Exception {
    requested();
    FakeAgent before = FakeAgent.offering(grpcPort(), "dropped", 2, List.of("ir1", "ir2"));
    AttemptRef running = before.nextAssignment().getAttempt();
    before.close();
    await().until(() -> agentNamed("dropped").get("state").asString().equals("OFFLINE"));
    String second = requested();
    try (FakeAgent after =
        FakeAgent.offering(grpcPort(), "dropped", 2, List.of("ir1", "ir2"), running)) {
      assertThat(after.receivesNothingFor(300)).isTrue();
      assertThat(build(second).get("waitingFor").asString()).startsWith("another build uses");
    }
  }

  @Test
  void aBuildWaitsForAnAgentThatOffersItsDevices() throws Exception {
    String id = requested();
    try (FakeAgent agent = FakeAgent.offering(grpcPort(), "half-bench", 1, List.of("ir1"))) {
      assertThat(agent.receivesNothingFor(300)).isTrue();
      assertThat(build(id).get("waitingFor").asString())
          .startsWith("no agent offers the device ir2");
    }
  }

  private void submit(FakeAgent agent, Assignment assignment) {
    agent.submit(assignment.getAttempt(), FakeAgent.result(agent.download(assignment), List.of()));
  }

  private Api.Answer request(String options) {
    return api.post("/api/v1/builds", "{\"suiteId\":\"" + suiteId + "\"," + options + "}");
  }

  private String requested() {
    return api.build(suiteId);
  }

  private JsonNode build(String id) {
    return api.get("/api/v1/builds/" + id).expect(200).json();
  }

  private JsonNode agentNamed(String name) {
    for (JsonNode agent : api.get("/api/v1/agents").expect(200).json()) {
      if (agent.get("name").asString().equals(name)) {
        return agent;
      }
    }
    throw new AssertionError("no agent " + name);
  }
}
