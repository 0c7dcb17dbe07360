package org.sitaf.server.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest.BodyPublishers;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/**
 * Calls each operation of the OpenAPI document with each role, and compares the outcome with the
 * rules below.
 */
@Tag("slow")
class RolesTest extends ServerTest {
  private static final String ANONYMOUS = "anonymous";
  private static final List<String> ROLES =
      List.of("VIEWER", "TESTER", "OPERATOR", "ADMINISTRATOR");
  private static final Set<String> METHODS = Set.of("get", "put", "post", "patch", "delete");

  /** By default reading requires VIEWER and changing requires TESTER. */
  private static final Map<String, String> EXCEPTIONS =
      Map.of(
          "signIn",
          ANONYMOUS,
          "receiveGitHook",
          ANONYMOUS,
          "signOut",
          "VIEWER",
          "changePassword",
          "VIEWER");

  private static final List<String> FOR_ADMINISTRATORS =
      List.of("/api/v1/users", "/api/v1/audit", "/api/v1/enrolments", "/api/v1/webhooks");

  private record Operation(String method, String path, String id) {
    String requiredRole() {
      if (EXCEPTIONS.containsKey(id)) {
        return EXCEPTIONS.get(id);
      }
      boolean reads = method.equals("get");
      if (FOR_ADMINISTRATORS.stream().anyMatch(path::startsWith)
          || !reads && path.startsWith("/api/v1/agents")) {
        return "ADMINISTRATOR";
      }
      // Users manage their own tokens and session.
      return reads || path.startsWith("/api/v1/tokens") || path.startsWith("/api/v1/session")
          ? "VIEWER"
          : "TESTER";
    }
  }

  @Test
  void everyOperationRequiresItsRole() {
    List<Operation> operations = operations();
    assertThat(operations).hasSizeGreaterThan(30);
    List<Api> callers = ROLES.stream().map(role -> new Api(httpPort(), tokenOf(role))).toList();
    List<String> wrong = new ArrayList<>();
    for (Operation operation : operations) {
      int required = ROLES.indexOf(operation.requiredRole());
      check(operation, ANONYMOUS, new Api(httpPort(), null), required < 0 ? "open" : "401", wrong);
      for (int role = 0; role < ROLES.size(); role++) {
        check(
            operation,
            ROLES.get(role),
            callers.get(role),
            role >= required ? "open" : "403",
            wrong);
      }
    }
    assertThat(wrong).isEmpty();
  }

  private static void check(
      Operation operation, String role, Api api, String expected, List<String> wrong) {
    Api.Answer answer = api.send(request(api, operation));
    boolean rejected =
        answer.status() == 403 && answer.text().contains("Your role does not allow this")
            || answer.status() == 401 && !answer.text().contains("Wrong name or password");
    String actual = rejected ? Integer.toString(answer.status()) : "open";
    if (!actual.equals(expected) || answer.status() >= 500) {
      wrong.add(operation + " as " + role + ": " + answer.status() + ", expected " + expected);
    }
  }

  /**
   * Uses ids of nothing, which other tests do not use: a PUT can create a calendar of that name.
   */
  private static java.net.http.HttpRequest.Builder request(Api api, Operation operation) {
    String path = operation.path().replaceAll("\\{[^}]*}", "not-there");
    return api.request(path)
        .timeout(Duration.ofSeconds(30))
        .header("Content-Type", "application/json")
        .method(
            operation.method().toUpperCase(java.util.Locale.ROOT),
            operation.method().equals("get")
                ? BodyPublishers.noBody()
                : BodyPublishers.ofString("{\"name\":\"\",\"password\":\"\"}"));
  }

  private List<Operation> operations() {
    List<Operation> operations = new ArrayList<>();
    JsonNode document = api.get("/v3/api-docs").expect(200).json();
    document
        .get("paths")
        .properties()
        .forEach(
            path ->
                path.getValue()
                    .properties()
                    .forEach(
                        method -> {
                          if (METHODS.contains(method.getKey())) {
                            operations.add(
                                new Operation(
                                    method.getKey(),
                                    path.getKey(),
                                    method.getValue().get("operationId").asString()));
                          }
                        }));
    return operations;
  }
}
