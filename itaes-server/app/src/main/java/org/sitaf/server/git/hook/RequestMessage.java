package org.sitaf.server.git.hook;

import java.util.Optional;
import java.util.Set;
import org.sitaf.server.git.request.ReportedRequest;
import org.sitaf.server.git.source.Forge;
import tools.jackson.databind.JsonNode;

/**
 * Reads messages about pull and merge requests. They are as the forges document them: GitHub,
 * "Webhook events and payloads", pull_request; GitLab, "Webhook events", merge request events;
 * Gitea and Forgejo send what GitHub sends.
 */
final class RequestMessage {
  /** Gitea writes "synchronized". An edit can change the title or the branch. */
  private static final Set<String> PULL_REQUEST_ACTIONS =
      Set.of("opened", "synchronize", "synchronized", "reopened", "edited", "closed");

  private static final Set<String> MERGE_REQUEST_ACTIONS =
      Set.of("open", "update", "reopen", "close", "merge");

  private RequestMessage() {}

  /**
   * Reads a message.
   *
   * @return empty if it is about something else, such as a label
   * @throws org.sitaf.server.error.RequestException if it has no number or no head
   */
  static Optional<ReportedRequest> parse(Forge forge, JsonNode body) {
    return forge == Forge.GITLAB ? mergeRequest(body) : pullRequest(forge, body);
  }

  private static Optional<ReportedRequest> pullRequest(Forge forge, JsonNode body) {
    String action = text(body, "action");
    if (!PULL_REQUEST_ACTIONS.contains(action)) {
      return Optional.empty();
    }
    JsonNode request = body.path("pull_request");
    JsonNode head = request.path("head");
    JsonNode base = request.path("base");
    return Optional.of(
        new ReportedRequest(
            forge,
            number(request.path("number")),
            text(request, "title"),
            text(request.path("user"), "login"),
            text(head, "sha"),
            text(base.path("repo"), "full_name"),
            text(base, "ref"),
            // The repository of the head is null if the fork was deleted.
            !isSame(head.path("repo").path("id"), base.path("repo").path("id")),
            !action.equals("closed") && !text(request, "state").equals("closed")));
  }

  private static Optional<ReportedRequest> mergeRequest(JsonNode body) {
    JsonNode request = body.path("object_attributes");
    if (!MERGE_REQUEST_ACTIONS.contains(text(request, "action"))) {
      return Optional.empty();
    }
    return Optional.of(
        new ReportedRequest(
            Forge.GITLAB,
            number(request.path("iid")),
            text(request, "title"),
            text(body.path("user"), "name"),
            text(request.path("last_commit"), "id"),
            text(request.path("target"), "path_with_namespace"),
            text(request, "target_branch"),
            !isSame(request.path("source_project_id"), request.path("target_project_id")),
            text(request, "state").equals("opened")));
  }

  /** 0 if it is no number of a request. */
  private static int number(JsonNode node) {
    return node.isIntegralNumber() && node.canConvertToInt() ? node.intValue() : 0;
  }

  private static String text(JsonNode node, String name) {
    JsonNode value = node.path(name);
    return value.isString() ? value.asString() : "";
  }

  private static boolean isSame(JsonNode one, JsonNode other) {
    return one.isIntegralNumber() && one.equals(other);
  }
}
