package org.sitaf.server.support;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Holds each answer that a test gets against what the OpenAPI document declares. */
final class DeclaredAnswers {
  /** Of what no operation has been chosen for. */
  private static final Set<Integer> BEFORE_ANY_OPERATION = Set.of(405, 406, 421);

  private static List<Declared> operations = List.of();

  private DeclaredAnswers() {}

  private record Declared(String method, Pattern path, int literals, Set<String> answers) {}

  /**
   * Throws where the operation of a request does not declare the status; only 4xx are checked.
   *
   * @param root of the server, which has the document
   */
  static void require(String root, String method, String path, int status) {
    if (status < 400 || status >= 500 || BEFORE_ANY_OPERATION.contains(status)) {
      return;
    }
    operations(root).stream()
        .filter(o -> o.method().equals(method) && o.path().matcher(path).matches())
        .max(java.util.Comparator.comparingInt(Declared::literals))
        .filter(o -> !o.answers().contains(Integer.toString(status)))
        .ifPresent(
            o -> {
              throw new AssertionError(
                  "%s %s answers %d; the OpenAPI document declares %s"
                      .formatted(method, path, status, o.answers()));
            });
  }

  private static synchronized List<Declared> operations(String root) {
    if (operations.isEmpty()) {
      operations =
          document(root)
              .get("paths")
              .propertyStream()
              .flatMap(
                  path ->
                      path.getValue()
                          .propertyStream()
                          .map(operation -> declared(path.getKey(), operation)))
              .toList();
    }
    return operations;
  }

  private static JsonNode document(String root) {
    HttpRequest request =
        HttpRequest.newBuilder(URI.create(root + "/v3/api-docs"))
            .header("Authorization", "Bearer " + ServerTest.TOKEN)
            .build();
    try (var body = HttpClient.newHttpClient().send(request, BodyHandlers.ofInputStream()).body()) {
      return JsonMapper.shared().readTree(body);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  private static Declared declared(String path, java.util.Map.Entry<String, JsonNode> operation) {
    String pattern =
        path.replace(".", "\\.").replace("{path}", ".+").replaceAll("\\{\\w+}", "[^/]+");
    return new Declared(
        operation.getKey().toUpperCase(Locale.ROOT),
        Pattern.compile(pattern),
        path.replaceAll("\\{\\w+}", "").length(),
        new HashSet<>(operation.getValue().get("responses").propertyNames()));
  }
}
