package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.UUID;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.sitaf.server.git.RequestHook.Kind;
import org.sitaf.server.support.Api;
import tools.jackson.databind.JsonNode;

/** What the stories of pull and merge requests share: requests of a forge, and its messages. */
abstract class RequestStory extends GitStory {
  private String secret = "";

  /** Creates an activity whose forge may send messages. */
  String createWithHook(String further) {
    String activity = create(further);
    secret =
        api.post("/api/v1/activities/" + activity + "/git/hook", "")
            .expect(201)
            .json()
            .get("secret")
            .asString();
    return activity;
  }

  /** Settings of a forge that gets no statuses in this story. */
  static String forge(Kind kind) {
    return ", \"forge\": \"%s\", \"apiUrl\": \"http://localhost:1\", \"project\": \"robots/sensors\", \"forgeToken\": \"t\""
        .formatted(kind);
  }

  /**
   * Commits a change as the head of a request, and returns to the branch.
   *
   * @param from a commit
   * @param failing numbers of the cases that fail
   */
  String push(Kind kind, int number, String from, String failing) {
    repository.git("checkout", "-q", from);
    repository.write(DATA_FILE, failing);
    String head = repository.commit("Request " + UUID.randomUUID());
    repository.git("update-ref", kind.reference(number), head);
    repository.git("checkout", "-q", "main");
    return head;
  }

  void send(String activity, RequestHook hook) {
    hook.send(httpPort(), activity, secret).expect(202);
  }

  /** Sends a message again, or with another secret. */
  Api.Answer send(String activity, RequestHook hook, String wrongSecret, String delivery) {
    return hook.send(httpPort(), activity, wrongSecret.isEmpty() ? secret : wrongSecret, delivery);
  }

  Api.Answer sendBody(String activity, Kind kind, String body) {
    return RequestHook.send(httpPort(), activity, kind, body, secret, UUID.randomUUID().toString());
  }

  static String requests(String activity) {
    return "/api/v1/activities/" + activity + "/git/requests";
  }

  JsonNode awaitRequest(String activity, int number, Predicate<JsonNode> condition) {
    return await(requests(activity) + "/" + number, condition);
  }

  /** Waits until a head of a request has its results, and returns its commit. */
  JsonNode awaitBuilt(String activity, int number, String head) {
    return awaitRequest(
            activity,
            number,
            request ->
                request.path("commit").path("sha").asString("").equals(head)
                    && request.get("commit").get("state").asString().equals("DONE"))
        .get("commit");
  }

  Api.Answer build(Api caller, String activity, int number, String head) {
    return caller.post(
        requests(activity) + "/" + number + "/build", "{\"head\": \"%s\"}".formatted(head));
  }

  JsonNode commitsOf(String activity, int number) {
    return get("/api/v1/activities/" + activity + "/git/commits?request=" + number).get("items");
  }

  static JsonNode cell(JsonNode commit) {
    assertThat(commit.get("cells")).hasSize(1);
    return commit.get("cells").get(0);
  }

  /** Whether any of the server's copies of repositories has a commit. */
  static boolean isFetched(String sha) throws IOException, InterruptedException {
    try (Stream<Path> copies = Files.list(data().resolve("git"))) {
      for (Path copy : copies.toList()) {
        Process git =
            new ProcessBuilder(List.of("git", "--git-dir", copy.toString(), "cat-file", "-e", sha))
                .redirectErrorStream(true)
                .start();
        git.getInputStream().readAllBytes();
        if (git.waitFor() == 0) {
          return true;
        }
      }
    }
    return false;
  }
}
