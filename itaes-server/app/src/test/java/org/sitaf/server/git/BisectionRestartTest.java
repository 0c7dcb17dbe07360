package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerProcess;
import org.sitaf.server.support.ServerTest;
import org.sitaf.server.support.TestRepository;
import tools.jackson.databind.JsonNode;

/** A search for the first bad commit continues when the server was killed. */
@Tag("slow")
class BisectionRestartTest {
  private static final Duration TIMEOUT = Duration.ofSeconds(120);
  private static final String FOLDER = "robots/infrared";

  private final Path data = ServerTest.temporary();
  private final Path repositories = ServerTest.temporary();

  @Test
  void aSearchSurvivesAServerThatIsKilledBetweenItsBuilds() throws Exception {
    TestRepository repository = TestRepository.create(repositories.resolve("sensors"));
    repository.write(FOLDER, Activities.files());
    repository.write(FOLDER + "/data/failing.txt", "");
    repository.commit("First");
    List<String> shas = new ArrayList<>();
    String search;
    Assignment underWay;
    TestApplication application;
    try (ServerProcess server = start();
        FakeAgent agent = FakeAgent.register(server.grpcPort(), "survivor", "java")) {
      String activity =
          server
              .api()
              .post(
                  "/api/v1/git-activities",
                  "{\"url\": \"%s\", \"branch\": \"main\", \"folder\": \"%s\", \"intervalS\": 3600}"
                      .formatted(repository.fileUrl(), FOLDER))
              .expect(201)
              .id();
      String git = "/api/v1/activities/" + activity + "/git";
      answer(agent);
      await(server.api(), git + "/commits", commits -> isDone(commits, 1));
      for (int i = 0; i < 8; i++) {
        repository.write(FOLDER + "/data/failing.txt", i < 5 ? "" : "7");
        repository.write(FOLDER + "/data/note.txt", "Note " + i);
        shas.add(repository.commit("Change " + i));
      }
      server.api().post(git + "/fetch", "").expect(202);
      answer(agent);
      await(server.api(), git + "/commits", commits -> isDone(commits, 9));
      server
          .api()
          .post(git + "/bisections", "{\"commit\": \"%s\"}".formatted(shas.get(7)))
          .expect(201);
      search = git + "/bisections/1";
      answer(agent);
      underWay = agent.nextAssignment();
      application = agent.download(underWay);
      server.kill();
    }
    try (ServerProcess server = start();
        FakeAgent agent =
            FakeAgent.register(server.grpcPort(), "survivor", "java", underWay.getAttempt())) {
      JsonNode begun = server.api().get(search).expect(200).json();
      assertThat(begun.get("state").asString()).isEqualTo("RUNNING");
      assertThat(begun.get("tested")).hasSize(1);
      // Of 8 commits the first bad one is known after 3 tests.
      submit(agent, underWay, application);
      answer(agent);
      JsonNode found = await(server.api(), search, s -> s.get("state").asString().equals("FOUND"));
      assertThat(found.get("firstBad")).hasSize(1);
      assertThat(found.get("firstBad").get(0).get("sha").asString()).isEqualTo(shas.get(5));
      assertThat(found.get("tested")).hasSize(3);
      assertThat(found.get("builds").asInt()).isEqualTo(3);
    }
  }

  private ServerProcess start() throws Exception {
    // The agent sends no heartbeats.
    return new ServerProcess(data, "--sitaf.git.file-folders=" + repositories, "--sitaf.lease=10m");
  }

  private static boolean isDone(JsonNode commits, int count) {
    return commits.get("items").size() == count
        && commits.get("items").get(0).get("state").asString().equals("DONE");
  }

  /** Executes the next build. */
  private static void answer(FakeAgent agent) {
    Assignment assignment = agent.nextAssignment();
    submit(agent, assignment, agent.download(assignment));
  }

  private static void submit(FakeAgent agent, Assignment assignment, TestApplication application) {
    String failing = application.activity().files().text("data/failing.txt").orElse("").strip();
    boolean accepted =
        agent.submit(
            assignment.getAttempt(),
            FakeAgent.result(
                application, failing.isEmpty() ? List.of() : List.of(Integer.valueOf(failing))));
    assertThat(accepted).isTrue();
  }

  private static JsonNode await(Api api, String path, Predicate<JsonNode> condition)
      throws InterruptedException {
    Instant deadline = Instant.now().plus(TIMEOUT);
    while (true) {
      JsonNode found = api.get(path).expect(200).json();
      if (condition.test(found)) {
        return found;
      }
      if (Instant.now().isAfter(deadline)) {
        throw new AssertionError("timed out: " + path + ": " + found);
      }
      Thread.sleep(50);
    }
  }
}
