package org.sitaf.server.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.grpc.Status;
import java.util.List;
import java.util.UUID;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/**
 * Agents enrol with a token, authenticate with their key, and can only access their own attempts.
 */
@Tag("slow")
class AgentAccessTest extends ServerTest {
  private final String name = "a-" + UUID.randomUUID().toString().substring(0, 8);

  @Test
  void callsWithoutValidKeyAreRejected() throws Exception {
    try (FakeAgent agent = FakeAgent.dial(grpcPort())) {
      agent.heartbeat();
      assertThat(codeOf(agent.end())).isEqualTo(Status.Code.UNAUTHENTICATED);
      assertRejected(
          Status.Code.UNAUTHENTICATED,
          () -> agent.download(AttemptRef.getDefaultInstance(), "0".repeat(64)));
      agent.useKey("sitaf-agent_" + "x".repeat(43));
      assertRejected(
          Status.Code.UNAUTHENTICATED,
          () -> agent.download(AttemptRef.getDefaultInstance(), "0".repeat(64)));
    }
  }

  @Test
  void enrolmentIsLimitedToItsUsesAndNamesAreUnique() {
    String token = enrolment("{\"uses\":2,\"hours\":1}").get("secret").asString();
    try (FakeAgent agent = FakeAgent.dial(grpcPort())) {
      agent.enrolWith(token, name);
      assertRejected(Status.Code.ALREADY_EXISTS, () -> agent.enrolWith(token, name));
      agent.enrolWith(token, name + "-2");
      assertRejected(Status.Code.UNAUTHENTICATED, () -> agent.enrolWith(token, name + "-3"));
      assertRejected(Status.Code.UNAUTHENTICATED, () -> agent.enrolWith("guessed", name + "-4"));
    }
  }

  @Test
  void enrolmentForAnAgentReplacesItsKey() {
    try (FakeAgent agent = FakeAgent.register(grpcPort(), name, "java");
        FakeAgent successor = FakeAgent.dial(grpcPort())) {
      String token =
          enrolment("{\"agent\":\"%s\",\"uses\":1,\"hours\":1}".formatted(name))
              .get("secret")
              .asString();
      assertRejected(
          Status.Code.UNAUTHENTICATED, () -> successor.enrolWith(token, name + "-other"));
      successor.enrolWith(token, name);
      agent.heartbeat();
      assertThat(codeOf(agent.end())).isEqualTo(Status.Code.UNAUTHENTICATED);
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void deletedEnrolmentIsRejected() {
    JsonNode made = enrolment("{\"uses\":5,\"hours\":1}");
    String id = made.get("enrolment").get("id").asString();
    assertThat(api.get("/api/v1/enrolments").expect(200).text())
        .contains(id)
        .doesNotContain(made.get("secret").asString());
    api.delete("/api/v1/enrolments/" + id).expect(204);
    try (FakeAgent agent = FakeAgent.dial(grpcPort())) {
      assertRejected(
          Status.Code.UNAUTHENTICATED, () -> agent.enrolWith(made.get("secret").asString(), name));
    }
  }

  @Test
  void keyIsValidForOneNameOnly() throws Exception {
    try (FakeAgent agent = FakeAgent.dial(grpcPort())) {
      agent.enrolWith(ENROLMENT, name);
      agent.sendRegisterUnenrolled(name + "-other", 1, List.of(), "java");
      assertThat(codeOf(agent.end())).isEqualTo(Status.Code.PERMISSION_DENIED);
    }
  }

  @Test
  void revokedKeyEndsTheStreamAndIsRejected() throws Exception {
    // The first request of its kind may take longer than an agent may be silent.
    api.delete("/api/v1/agents/" + name + "/key").expect(404);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), name, "java")) {
      api.delete("/api/v1/agents/" + name + "/key").expect(204);
      api.delete("/api/v1/agents/" + name + "/key").expect(404);
      agent.heartbeat();
      assertThat(codeOf(agent.end())).isEqualTo(Status.Code.UNAUTHENTICATED);
      assertRejected(
          Status.Code.UNAUTHENTICATED,
          () -> agent.download(AttemptRef.getDefaultInstance(), "0".repeat(64)));
    }
  }

  @Test
  void agentCannotAccessAttemptsOfAnotherAgent() {
    String build = api.build(api.suite(api.upload(Activities.zip())));
    try (FakeAgent owner = FakeAgent.register(grpcPort(), name, "java");
        FakeAgent other = FakeAgent.dial(grpcPort())) {
      Assignment assignment = owner.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      byte[] document = FakeAgent.result(owner.download(assignment), List.of());
      String sha256 = assignment.getFiles(0).getSha256();
      other.enrol(name + "-other");
      assertRejected(Status.Code.PERMISSION_DENIED, () -> other.download(attempt, sha256));
      assertRejected(
          Status.Code.PERMISSION_DENIED,
          () -> other.report(attempt, AttemptState.ATTEMPT_STATE_RUNNING));
      assertRejected(Status.Code.PERMISSION_DENIED, () -> other.appendLog(attempt, 0, "forged"));
      assertRejected(Status.Code.PERMISSION_DENIED, () -> other.submit(attempt, document));
      assertThat(api.get("/api/v1/builds/" + build).json().get("state").asString())
          .isNotIn("RUNNING", "DONE");
      assertThat(owner.submit(attempt, document)).isTrue();
    }
  }

  private JsonNode enrolment(String json) {
    return api.post("/api/v1/enrolments", json).expect(201).json();
  }

  private static void assertRejected(Status.Code code, ThrowingCallable call) {
    assertThatThrownBy(call).satisfies(e -> assertThat(codeOf(e)).isEqualTo(code));
  }

  private static Status.Code codeOf(Throwable failure) {
    return Status.fromThrowable(failure).getCode();
  }
}
