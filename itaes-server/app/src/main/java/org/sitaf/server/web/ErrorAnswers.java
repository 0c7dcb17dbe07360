package org.sitaf.server.web;

import io.swagger.v3.oas.models.Components;
import io.swagger.v3.oas.models.Operation;
import io.swagger.v3.oas.models.PathItem;
import io.swagger.v3.oas.models.media.Content;
import io.swagger.v3.oas.models.media.MediaType;
import io.swagger.v3.oas.models.media.Schema;
import io.swagger.v3.oas.models.parameters.Parameter;
import io.swagger.v3.oas.models.responses.ApiResponse;
import io.swagger.v3.oas.models.responses.ApiResponses;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.springframework.http.HttpHeaders;

/** Which problem details an operation answers with, by what it takes and what it does. */
final class ErrorAnswers {
  private static final Map<Integer, String> DESCRIPTIONS =
      new TreeMap<>(
          Map.ofEntries(
              Map.entry(400, "The request is wrong: a parameter, a header or the body."),
              Map.entry(401, "Nobody is signed in, or the name, password or token is wrong."),
              Map.entry(403, "The caller's role does not allow it, or the CSRF token is missing."),
              Map.entry(404, "There is no such thing."),
              Map.entry(408, "The body took too long to arrive."),
              Map.entry(409, "The present state does not allow it."),
              Map.entry(412, "Somebody else changed it: it has another version than If-Match."),
              Map.entry(413, "The body is too large, or a quota is used up."),
              Map.entry(415, "The body has another media type than the operation takes."),
              Map.entry(422, "The input is invalid; diagnostics says what is wrong, and where."),
              Map.entry(428, "If-Match is missing."),
              Map.entry(429, "Too many attempts; Retry-After says when to try again."),
              Map.entry(503, "The server is busy; Retry-After says when to try again."),
              Map.entry(507, "The server's disk is full.")));

  private static final String PROBLEM = "application/problem+json";
  private static final String ANY = "default";

  /** Of these an administrator alone may even look. */
  private static final List<String> ADMINISTRATORS =
      List.of("/api/v1/users", "/api/v1/audit", "/api/v1/enrolments", "/api/v1/webhooks");

  /** They are for people in a session; a token is refused. */
  private static final Set<String> OF_SESSIONS = Set.of("getUsage");

  /** They check a password. */
  private static final Set<String> LIMITED = Set.of("signIn", "changePassword");

  /** They compute from what is stored, which may have become invalid. */
  private static final Set<String> COMPUTED = Set.of("getHarness", "describeActivity");

  private ErrorAnswers() {}

  /** Adds the answers that operations refer to. */
  static void addTo(Components components) {
    DESCRIPTIONS.forEach((status, text) -> components.addResponses(name(status), problem(text)));
    components.addResponses(name(ANY), problem("Any other error."));
  }

  /** Declares the answers of an operation. */
  static void addTo(String path, PathItem.HttpMethod method, Operation operation) {
    ApiResponses responses = operation.getResponses();
    DESCRIPTIONS
        .keySet()
        .forEach(
            status -> {
              if (isPossible(status, path, method, operation)) {
                responses.addApiResponse(Integer.toString(status), reference(name(status)));
              }
            });
    responses.addApiResponse(ANY, reference(name(ANY)));
  }

  private static boolean isPossible(
      int status, String path, PathItem.HttpMethod method, Operation operation) {
    boolean changes = method != PathItem.HttpMethod.GET;
    boolean body = operation.getRequestBody() != null;
    boolean parameters = has(operation, "query") || has(operation, "header");
    boolean versioned = has(operation, HttpHeaders.IF_MATCH);
    String id = operation.getOperationId();
    return switch (status) {
      case 400 -> body || parameters || path.contains("{");
      case 401 -> true;
      case 403 ->
          changes || OF_SESSIONS.contains(id) || ADMINISTRATORS.stream().anyMatch(path::startsWith);
      case 404 -> body || path.contains("{") || has(operation, "query");
      case 408, 413, 415 -> body;
      case 409 -> changes || COMPUTED.contains(id);
      case 412, 428 -> versioned;
      case 422 -> body || versioned || COMPUTED.contains(id);
      case 429 -> LIMITED.contains(id);
      case 503 -> body;
      case 507 -> changes;
      default -> false;
    };
  }

  /** Whether it has a parameter of a kind, or of a name. */
  private static boolean has(Operation operation, String kindOrName) {
    List<Parameter> parameters = operation.getParameters();
    return parameters != null
        && parameters.stream()
            .anyMatch(p -> kindOrName.equals(p.getIn()) || kindOrName.equals(p.getName()));
  }

  private static ApiResponse problem(String description) {
    return new ApiResponse()
        .description(description)
        .content(
            new Content()
                .addMediaType(
                    PROBLEM,
                    new MediaType().schema(new Schema<>().$ref("#/components/schemas/Problem"))));
  }

  private static ApiResponse reference(String name) {
    return new ApiResponse().$ref("#/components/responses/" + name);
  }

  private static String name(Object status) {
    return "Problem" + (status.equals(ANY) ? "" : status);
  }
}
