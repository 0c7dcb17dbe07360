package org.sitaf.cli.system;

import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.diagnostic.Severity;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Client of a server's REST interface ({@code /api/v1}). */
final class ServerClient {
  private static final Duration TIMEOUT = Duration.ofSeconds(60);
  private static final int OUTDATED = 412;
  private static final String JSON = "application/json";

  private final HttpClient http =
      HttpClient.newBuilder().connectTimeout(Duration.ofSeconds(10)).build();
  private final JsonMapper json = JsonMapper.builder().build();
  private final URI api;
  private final String token;

  /**
   * Creates a client of one server.
   *
   * @param token for {@code Authorization: Bearer}
   */
  ServerClient(URI address, String token) {
    this.api = address.resolve("/api/v1/");
    this.token = token;
  }

  /**
   * Posts a body and returns the response.
   *
   * @throws InvalidInputException if the server rejects it; contains the server's diagnostics
   */
  JsonNode post(String path, String contentType, byte[] body)
      throws IOException, InterruptedException {
    return parse(
        send(
            request(path)
                .header("Content-Type", contentType)
                .POST(BodyPublishers.ofByteArray(body))));
  }

  /** Posts JSON. */
  JsonNode post(String path, Object body) throws IOException, InterruptedException {
    return post(path, JSON, json.writeValueAsBytes(body));
  }

  /**
   * Replaces a resource and returns the response; null if it no longer has this version.
   *
   * @throws InvalidInputException if the server rejects it for another reason
   */
  @Nullable JsonNode put(String path, String contentType, byte[] body, long version)
      throws IOException, InterruptedException {
    HttpResponse<byte[]> response =
        answer(
            request(path)
                .header("Content-Type", contentType)
                .header("If-Match", "\"" + version + "\"")
                .PUT(BodyPublishers.ofByteArray(body)));
    if (response.statusCode() == OUTDATED) {
      return null;
    }
    return parse(accepted(response));
  }

  /** Gets JSON. */
  JsonNode get(String path) throws IOException, InterruptedException {
    return parse(send(request(path).header("Accept", JSON).GET()));
  }

  /** Gets a document without parsing it. */
  byte[] document(String path) throws IOException, InterruptedException {
    return send(request(path).GET()).body();
  }

  /**
   * Gets a log from an offset on.
   *
   * @param offset in bytes
   */
  byte[] log(String buildPath, long offset) throws IOException, InterruptedException {
    return document(buildPath + "/log?offset=" + offset);
  }

  private HttpRequest.Builder request(String path) {
    return HttpRequest.newBuilder(api.resolve(path))
        .timeout(TIMEOUT)
        .header("Authorization", "Bearer " + token);
  }

  private JsonNode parse(HttpResponse<byte[]> response) {
    return json.readTree(response.body());
  }

  private HttpResponse<byte[]> send(HttpRequest.Builder request)
      throws IOException, InterruptedException {
    return accepted(answer(request));
  }

  private HttpResponse<byte[]> answer(HttpRequest.Builder request)
      throws IOException, InterruptedException {
    try {
      return http.send(request.build(), BodyHandlers.ofByteArray());
    } catch (ConnectException e) {
      throw new IOException("no server answers at " + api.resolve("/"), e);
    }
  }

  private HttpResponse<byte[]> accepted(HttpResponse<byte[]> response) {
    if (response.statusCode() / 100 != 2) {
      throw refusal(response);
    }
    return response;
  }

  private InvalidInputException refusal(HttpResponse<byte[]> response) {
    String what = response.request().method() + " " + response.uri().getPath();
    List<Diagnostic> diagnostics = new ArrayList<>();
    String contentType = response.headers().firstValue("Content-Type").orElse("");
    if (contentType.startsWith("application/problem+json")) {
      JsonNode problem = parse(response);
      for (JsonNode d : problem.path("diagnostics")) {
        diagnostics.add(
            new Diagnostic(
                d.path("severity").asString("ERROR").equalsIgnoreCase("warning")
                    ? Severity.WARNING
                    : Severity.ERROR,
                d.path("file").asString(""),
                d.path("line").asInt(0),
                d.path("element").asString(""),
                d.path("message").asString("")));
      }
      if (diagnostics.isEmpty()) {
        diagnostics.add(
            Diagnostic.error(
                what, 0, "", problem.path("detail").asString(problem.path("title").asString(""))));
      }
    } else {
      diagnostics.add(
          Diagnostic.error(
              what,
              0,
              "",
              "HTTP "
                  + response.statusCode()
                  + ": "
                  + new String(response.body(), StandardCharsets.UTF_8).strip()));
    }
    return new InvalidInputException(diagnostics);
  }
}
