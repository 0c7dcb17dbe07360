package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.server.SitafServer;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** A server process that is killed and restarted. */
@Tag("slow")
class DurabilityTest {
  private static final Pattern LISTENING = Pattern.compile("listening http=(\\d+) grpc=(\\d+)");

  private final Path data = ServerTest.temporary();

  @Test
  void acknowledgedDataSurvivesKillAndRunningBuildContinues() throws Exception {
    String finished;
    String underWay;
    String suiteId;
    byte[] document;
    Assignment second;
    try (Running server = new Running()) {
      suiteId = server.api.suite(server.api.upload(Activities.zip()));
      finished = server.api.build(suiteId);
      try (FakeAgent agent = FakeAgent.register(server.grpcPort, "survivor", "java")) {
        Assignment first = agent.nextAssignment();
        document = FakeAgent.result(agent.download(first), List.of());
        assertThat(agent.submit(first.getAttempt(), document)).isTrue();
        server.process.destroyForcibly().waitFor();
        assertThat(agent.end()).isNotNull();
      }
    }
    try (Running server = new Running()) {
      JsonNode build = server.api.get("/api/v1/builds/" + finished).expect(200).json();
      assertThat(build.get("state").asString()).isEqualTo("DONE");
      assertThat(server.api.get("/api/v1/builds/" + finished + "/result/document").bytes())
          .isEqualTo(document);
      underWay = server.api.build(suiteId);
      try (FakeAgent agent = FakeAgent.register(server.grpcPort, "survivor", "java")) {
        second = agent.nextAssignment();
        assertThat(second.getAttempt().getBuildId()).isEqualTo(underWay);
        agent.report(second.getAttempt(), AttemptState.ATTEMPT_STATE_RUNNING);
        server.process.destroyForcibly().waitFor();
      }
    }
    try (Running server = new Running();
        FakeAgent agent =
            FakeAgent.register(server.grpcPort, "survivor", "java", second.getAttempt())) {
      assertThat(agent.submit(second.getAttempt(), document)).isTrue();
      JsonNode build = server.api.get("/api/v1/builds/" + underWay).expect(200).json();
      assertThat(build.get("state").asString()).isEqualTo("DONE");
      assertThat(build.get("attempt").asInt()).isEqualTo(1);
    }
  }

  /** A server process that stops when its standard input is closed, and thus with this test. */
  private final class Running implements AutoCloseable {
    final Process process;
    final Api api;
    final int grpcPort;

    Running() throws IOException {
      List<String> command = new ArrayList<>();
      command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
      command.addAll(List.of("-XX:TieredStopAtLevel=1", "-cp", classPath()));
      command.add(SitafServer.class.getName());
      command.addAll(
          List.of(
              "--server.port=0",
              "--spring.grpc.server.port=0",
              "--sitaf.stop-with-stdin=true",
              "--sitaf.data-directory=" + data));
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT);
      builder.environment().put("SITAF_ACCESS_LAUNCHERTOKEN", ServerTest.TOKEN);
      builder.environment().put("SITAF_ACCESS_LAUNCHERENROLMENT", ServerTest.ENROLMENT);
      process = builder.start();
      BufferedReader output = process.inputReader(StandardCharsets.UTF_8);
      StringBuilder startLog = new StringBuilder();
      for (String line = output.readLine(); line != null; line = output.readLine()) {
        startLog.append(line).append('\n');
        Matcher listening = LISTENING.matcher(line);
        if (listening.matches()) {
          api = new Api(Integer.parseInt(listening.group(1)));
          grpcPort = Integer.parseInt(listening.group(2));
          return;
        }
      }
      throw new IllegalStateException("the server did not start:\n" + startLog);
    }

    private String classPath() {
      return System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    }

    /** Stops the server by closing its standard input. */
    @Override
    public void close() throws IOException, InterruptedException {
      process.getOutputStream().close();
      if (!process.waitFor(60, TimeUnit.SECONDS)) {
        process.destroyForcibly();
        throw new AssertionError("the server did not end with its standard input");
      }
    }
  }
}
