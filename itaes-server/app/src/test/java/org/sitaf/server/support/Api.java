package org.sitaf.server.support;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.function.Predicate;
import org.awaitility.Awaitility;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A client of the server's REST interface. */
public final class Api {
  private static final JsonMapper JSON = JsonMapper.builder().build();

  /** For slow machines; a passing test does not wait this long. */
  private static final Duration TIMEOUT = Duration.ofSeconds(180);

  static {
    Awaitility.setDefaultTimeout(TIMEOUT);
  }

  private final HttpClient client =
      HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
  private final String root;
  private final @Nullable String token;

  /** A client with the launcher's token. */
  public Api(int port) {
    this(port, ServerTest.TOKEN);
  }

  /**
   * A client with an API token.
   *
   * @param token null for requests without authentication
   */
  public Api(int port, @Nullable String token) {
    this.root = "http://localhost:" + port;
    this.token = token;
  }

  @SuppressWarnings("ArrayRecordComponent") // Responses are not compared.
  public record Answer(int status, byte[] bytes, java.net.http.HttpHeaders headers) {
    public String text() {
      return new String(bytes, StandardCharsets.UTF_8);
    }

    public JsonNode json() {
      return JSON.readTree(bytes);
    }

    public String id() {
      return json().get("id").asString();
    }

    public Answer expect(int expected) {
      if (status != expected) {
        throw new AssertionError("expected " + expected + ", got " + status + ": " + text());
      }
      return this;
    }
  }

  public Answer get(String path) {
    return send(request(path).GET());
  }

  public Answer delete(String path) {
    return send(request(path).DELETE());
  }

  public Answer post(String path, String json) {
    return send(
        request(path)
            .header("Content-Type", "application/json")
            .POST(BodyPublishers.ofString(json)));
  }

  /** Sends a POST request with If-Match. */
  public Answer change(String path, String json, String ifMatch) {
    return send(
        request(path)
            .header("Content-Type", "application/json")
            .header("If-Match", ifMatch)
            .POST(BodyPublishers.ofString(json)));
  }

  public Answer post(String path, String type, byte[] body) {
    return send(request(path).header("Content-Type", type).POST(BodyPublishers.ofByteArray(body)));
  }

  public Answer put(String path, String type, byte[] body, @Nullable String ifMatch) {
    HttpRequest.Builder request =
        request(path).header("Content-Type", type).PUT(BodyPublishers.ofByteArray(body));
    return send(ifMatch == null ? request : request.header("If-Match", ifMatch));
  }

  public Answer send(HttpRequest.Builder request) {
    try {
      HttpRequest built = request.build();
      HttpResponse<byte[]> answer = client.send(built, BodyHandlers.ofByteArray());
      DeclaredAnswers.require(root, built.method(), built.uri().getPath(), answer.statusCode());
      return new Answer(answer.statusCode(), answer.body(), answer.headers());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  public HttpRequest.Builder request(String path) {
    HttpRequest.Builder request = HttpRequest.newBuilder(URI.create(root + path)).timeout(TIMEOUT);
    return token == null ? request : request.header("Authorization", "Bearer " + token);
  }

  /** Uploads an activity and returns its id. */
  public String upload(byte[] zip) {
    return post("/api/v1/activities", "application/zip", zip).expect(201).id();
  }

  /** Generates a suite and returns its id. */
  public String suite(String activityId) {
    return post(
            "/api/v1/activities/" + activityId + "/models/" + Activities.MODEL + "/suites", "{}")
        .expect(201)
        .id();
  }

  /** Requests a build and returns its id. */
  public String build(String suiteId) {
    return post("/api/v1/builds", "{\"suiteId\":\"" + suiteId + "\"}").expect(201).id();
  }

  /** Cancels all builds that have not ended. */
  public void cancelBuilds() {
    for (JsonNode build : get("/api/v1/builds?size=500").json().get("items")) {
      if (!build.has("finished")) {
        post("/api/v1/builds/" + build.get("id").asString() + "/cancel", "");
      }
    }
  }

  /** Waits with long polling until the build matches the condition. */
  public JsonNode await(String buildId, Predicate<JsonNode> condition) {
    Instant deadline = Instant.now().plus(TIMEOUT);
    JsonNode build = get("/api/v1/builds/" + buildId).expect(200).json();
    while (!condition.test(build)) {
      if (Instant.now().isAfter(deadline)) {
        throw new AssertionError("timed out waiting for the build: " + build);
      }
      build =
          get("/api/v1/builds/"
                  + buildId
                  + "?timeoutS=5&waitForChangeSince="
                  + build.get("version").asLong())
              .expect(200)
              .json();
    }
    return build;
  }

  public JsonNode awaitState(String buildId, String state) {
    return await(buildId, build -> build.get("state").asString().equals(state));
  }
}
