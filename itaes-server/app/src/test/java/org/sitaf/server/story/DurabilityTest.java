package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerProcess;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** A server process that is killed and restarted. */
@Tag("slow")
class DurabilityTest {
  private final Path data = ServerTest.temporary();

  @Test
  void acknowledgedDataSurvivesKillAndRunningBuildContinues() throws Exception {
    String finished;
    String underWay;
    String suiteId;
    byte[] document;
    Assignment second;
    try (ServerProcess server = new ServerProcess(data)) {
      suiteId = server.api().suite(server.api().upload(Activities.zip()));
      finished = server.api().build(suiteId);
      try (FakeAgent agent = FakeAgent.register(server.grpcPort(), "survivor", "java")) {
        Assignment first = agent.nextAssignment();
        document = FakeAgent.result(agent.download(first), List.of());
        assertThat(agent.submit(first.getAttempt(), document)).isTrue();
        server.kill();
        assertThat(agent.end()).isNotNull();
      }
    }
    try (ServerProcess server = new ServerProcess(data)) {
      JsonNode build = server.api().get("/api/v1/builds/" + finished).expect(200).json();
      assertThat(build.get("state").asString()).isEqualTo("DONE");
      assertThat(server.api().get("/api/v1/builds/" + finished + "/result/document").bytes())
          .isEqualTo(document);
      underWay = server.api().build(suiteId);
      try (FakeAgent agent = FakeAgent.register(server.grpcPort(), "survivor", "java")) {
        second = agent.nextAssignment();
        assertThat(second.getAttempt().getBuildId()).isEqualTo(underWay);
        agent.report(second.getAttempt(), AttemptState.ATTEMPT_STATE_RUNNING);
        server.kill();
      }
    }
    try (ServerProcess server = new ServerProcess(data);
        FakeAgent agent =
            FakeAgent.register(server.grpcPort(), "survivor", "java", second.getAttempt())) {
      assertThat(agent.submit(second.getAttempt(), document)).isTrue();
      JsonNode build = server.api().get("/api/v1/builds/" + underWay).expect(200).json();
      assertThat(build.get("state").asString()).isEqualTo("DONE");
      assertThat(build.get("attempt").asInt()).isEqualTo(1);
    }
  }
}
