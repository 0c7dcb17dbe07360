package org.sitaf.server.support;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * The part of the HTTP interfaces of GitHub, Gitea and GitLab that concerns commit statuses, with
 * the checks of their published schemas.
 */
public final class FakeForge implements AutoCloseable {
  private static final Pattern POST =
      Pattern.compile("/api/(?:repos|projects)/(.+)/statuses/([0-9a-f]{40})");
  private static final Pattern LIST =
      Pattern.compile(
          "/api/(?:repos/(.+)|projects/(.+)/repository)/commits/([0-9a-f]{40})/statuses");
  private static final JsonMapper JSON = JsonMapper.builder().build();
  private static final int MAX_DESCRIPTION = 140;

  /** What the forge stored. */
  public record Status(
      String project, String sha, String state, String context, String description, String url) {}

  private final HttpServer server;
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final String token;
  private final List<Status> statuses = new ArrayList<>();
  private final List<String> problems = new ArrayList<>();
  private final AtomicInteger lostAnswers = new AtomicInteger();
  private final AtomicInteger failures = new AtomicInteger();

  /** Starts a forge on a free port of the loopback. */
  public FakeForge(String token) {
    this.token = token;
    try {
      server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    server.setExecutor(threads);
    server.createContext("/", this::handle);
    server.start();
  }

  /** Root of its interface. */
  public String api() {
    return "http://localhost:" + server.getAddress().getPort() + "/api";
  }

  /** Stores the next statuses but does not answer. */
  public void loseAnswers(int count) {
    lostAnswers.set(count);
  }

  /** Refuses the next requests with 502. */
  public void fail(int count) {
    failures.set(count);
  }

  /** The statuses of a commit in the order in which they came. */
  public synchronized List<Status> of(String sha) {
    return statuses.stream().filter(s -> s.sha().equals(sha)).toList();
  }

  /** Requests that a forge would refuse. */
  public synchronized List<String> problems() {
    return List.copyOf(problems);
  }

  private void handle(HttpExchange exchange) throws IOException {
    try (exchange) {
      byte[] body = exchange.getRequestBody().readAllBytes();
      if (failures.getAndUpdate(n -> Math.max(0, n - 1)) > 0) {
        answer(exchange, 502, "{\"message\": \"bad gateway\"}");
        return;
      }
      String path = exchange.getRequestURI().getPath();
      boolean gitLab = path.startsWith("/api/projects/");
      if (!isAuthorized(exchange, gitLab)) {
        answer(exchange, 401, "{\"message\": \"401 Unauthorized\"}");
        return;
      }
      Matcher post = POST.matcher(path);
      Matcher list = LIST.matcher(path);
      if (exchange.getRequestMethod().equals("POST") && post.matches()) {
        store(exchange, post.group(1), post.group(2), gitLab, JSON.readTree(body));
      } else if (exchange.getRequestMethod().equals("GET") && list.matches()) {
        answer(exchange, 200, JSON.writeValueAsString(shown(list.group(3), gitLab)));
      } else {
        report("no such operation: " + exchange.getRequestMethod() + " " + path);
        answer(exchange, 404, "{}");
      }
    }
  }

  private boolean isAuthorized(HttpExchange exchange, boolean gitLab) {
    String sent = exchange.getRequestHeaders().getFirst(gitLab ? "PRIVATE-TOKEN" : "Authorization");
    return gitLab
        ? token.equals(sent)
        : ("Bearer " + token).equals(sent) || ("token " + token).equals(sent);
  }

  private synchronized void report(String problem) {
    problems.add(problem);
  }

  private void store(
      HttpExchange exchange, String project, String sha, boolean gitLab, JsonNode body)
      throws IOException {
    String state = body.path("state").asString("");
    List<String> allowed =
        gitLab
            ? List.of("pending", "running", "success", "failed", "canceled", "skipped")
            : List.of("pending", "success", "failure", "error");
    String description = body.path("description").asString("");
    String context = body.path(gitLab ? "name" : "context").asString("");
    if (!allowed.contains(state)
        || description.length() > MAX_DESCRIPTION
        || context.isEmpty()
        || !body.path("target_url").asString("").startsWith("http")) {
      report("refused: " + body);
      answer(exchange, 422, "{\"message\": \"Validation Failed\"}");
      return;
    }
    synchronized (this) {
      statuses.add(
          new Status(
              project, sha, state, context, description, body.path("target_url").asString("")));
    }
    if (lostAnswers.getAndUpdate(n -> Math.max(0, n - 1)) > 0) {
      // Closing the exchange without an answer ends the connection.
      return;
    }
    answer(exchange, 201, "{\"id\": 1}");
  }

  private synchronized List<Map<String, String>> shown(String sha, boolean gitLab) {
    return of(sha).stream()
        .map(
            s ->
                gitLab
                    ? Map.of("status", s.state(), "name", s.context())
                    : Map.of("state", s.state(), "context", s.context()))
        .toList();
  }

  private static void answer(HttpExchange exchange, int status, String json) throws IOException {
    byte[] bytes = json.getBytes(StandardCharsets.UTF_8);
    exchange.getResponseHeaders().add("Content-Type", "application/json");
    exchange.sendResponseHeaders(status, bytes.length);
    exchange.getResponseBody().write(bytes);
  }

  @Override
  public void close() {
    server.stop(0);
    threads.shutdownNow();
  }
}
