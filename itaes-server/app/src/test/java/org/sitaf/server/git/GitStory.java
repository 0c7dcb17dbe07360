package org.sitaf.server.git;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import org.sitaf.server.support.TestRepository;
import tools.jackson.databind.JsonNode;

/** What the stories of Git sources share: a repository with an activity, and an agent. */
abstract class GitStory extends ServerTest {
  /** Of the activity in the repository. */
  static final String FOLDER = "robots/infrared";

  /** Numbers of the cases that fail; the fake agent reads it, like a component its data. */
  static final String DATA_FILE = FOLDER + "/data/failing.txt";

  /** What the data of a component says that does not compile. */
  static final String NOT_COMPILING = "does not compile";

  private static final Duration TIMEOUT = Duration.ofSeconds(120);

  TestRepository repository = TestRepository.create(REPOSITORIES.resolve("unused"));
  private ExecutorService agents = Executors.newSingleThreadExecutor();
  private volatile boolean answering;
  private volatile boolean holding;

  @BeforeEach
  void createRepository() {
    repository = TestRepository.create(REPOSITORIES.resolve(UUID.randomUUID().toString()));
    repository.write(FOLDER, Activities.files());
    repository.write(DATA_FILE, "");
    repository.write("README.md", "A repository with an activity.");
    answering = true;
    holding = false;
    agents = Executors.newSingleThreadExecutor();
    agents.execute(this::answer);
  }

  @AfterEach
  void endAgent() {
    answering = false;
    agents.shutdownNow();
    for (JsonNode build : get("/api/v1/builds?size=500").get("items")) {
      if (!build.has("finished")) {
        api.post("/api/v1/builds/" + build.get("id").asString() + "/cancel", "");
      }
    }
  }

  /** Executes all builds; the cases fail that the activity's data name. */
  private void answer() {
    while (answering) {
      ScheduledExecutorService heart = Executors.newSingleThreadScheduledExecutor();
      try (FakeAgent agent = FakeAgent.register(grpcPort(), "of-git", "java")) {
        AtomicReference<AttemptRef> running = new AtomicReference<>();
        // The lease of the tests is short for a busy machine.
        heart.scheduleAtFixedRate(() -> beat(agent, running.get()), 0, 300, TimeUnit.MILLISECONDS);
        while (answering) {
          Assignment assignment = agent.nextAssignment();
          running.set(assignment.getAttempt());
          TestApplication application = agent.download(assignment);
          while (holding && answering) {
            pause();
          }
          boolean unused = submit(agent, assignment.getAttempt(), application);
          running.set(null);
        }
      } catch (AssertionError | RuntimeException e) {
        // A slow machine: the agent connects again, and the build is assigned again.
      } finally {
        heart.shutdownNow();
      }
    }
  }

  /** Lets the agent keep its results back, or deliver them. */
  void hold(boolean hold) {
    holding = hold;
  }

  private static boolean submit(FakeAgent agent, AttemptRef attempt, TestApplication application) {
    return data(application).startsWith(NOT_COMPILING)
        ? agent.submit(
            attempt,
            BuildFailure.newBuilder()
                .setCategory(BuildFailure.Category.COMPILATION)
                .setMessage("The component does not compile.")
                .build())
        : agent.submit(attempt, FakeAgent.result(application, failing(application), List.of()));
  }

  private static String data(TestApplication application) {
    return application.activity().files().text("data/failing.txt").orElse("");
  }

  private static void beat(FakeAgent agent, @Nullable AttemptRef running) {
    if (running == null) {
      agent.heartbeat();
    } else {
      agent.heartbeat(running);
    }
  }

  private static List<Integer> failing(TestApplication application) {
    return Arrays.stream(data(application).strip().split(" "))
        .filter(no -> !no.isEmpty())
        .map(Integer::valueOf)
        .toList();
  }

  JsonNode get(String path) {
    return api.get(path).expect(200).json();
  }

  static String settings(String url, String further) {
    return "{\"url\": \"%s\", \"branch\": \"main\", \"folder\": \"%s\", \"intervalS\": 3600%s}"
        .formatted(url, FOLDER, further);
  }

  /** Creates an activity from the repository. */
  String create(String further) {
    return api.post("/api/v1/git-activities", settings(repository.fileUrl(), further))
        .expect(201)
        .id();
  }

  void fetch(String activity) {
    api.post("/api/v1/activities/" + activity + "/git/fetch", "").expect(202);
  }

  JsonNode commits(String activity) {
    return get("/api/v1/activities/" + activity + "/git/commits").get("items");
  }

  /** Waits until a commit has a state. */
  JsonNode await(String activity, String sha, String state) {
    return await(
        "/api/v1/activities/" + activity + "/git/commits/" + sha,
        found -> found.get("state").asString().equals(state));
  }

  /** Waits until a resource matches a condition. */
  JsonNode await(String path, Predicate<JsonNode> condition) {
    Instant deadline = Instant.now().plus(TIMEOUT);
    while (true) {
      Api.Answer answer = api.get(path);
      if (answer.status() == 200 && condition.test(answer.json())) {
        return answer.json();
      }
      if (Instant.now().isAfter(deadline)) {
        throw new AssertionError("timed out: " + path + ": " + answer.text());
      }
      pause();
    }
  }

  private static void pause() {
    try {
      Thread.sleep(50);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }
}
