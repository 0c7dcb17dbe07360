package org.sitaf.server.git;

import java.net.http.HttpRequest.BodyPublishers;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.HexFormat;
import java.util.List;
import java.util.UUID;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.sitaf.server.support.Api;

/**
 * A message about a pull or merge request into {@code robots/sensors}, with the fields of the
 * forges' documented messages that matter.
 *
 * @param action as GitHub calls it
 */
record RequestHook(
    Kind kind, String action, int number, String head, String title, String branch, boolean fork) {
  /** The forge that sends it. */
  enum Kind {
    GITHUB,
    GITLAB,
    GITEA;

    /** Where the forge offers the head of a request. */
    String reference(int number) {
      return (this == GITLAB ? "refs/merge-requests/" : "refs/pull/") + number + "/head";
    }
  }

  static RequestHook opened(Kind kind, int number, String head) {
    return new RequestHook(kind, "opened", number, head, "Change the sensor", "main", false);
  }

  RequestHook action(String other) {
    return new RequestHook(kind, other, number, head, title, branch, fork);
  }

  RequestHook head(String other) {
    return new RequestHook(kind, "synchronize", number, other, title, branch, fork);
  }

  RequestHook title(String other) {
    return new RequestHook(kind, action, number, head, other, branch, fork);
  }

  RequestHook into(String other) {
    return new RequestHook(kind, action, number, head, title, other, fork);
  }

  RequestHook fromFork() {
    return new RequestHook(kind, action, number, head, title, branch, true);
  }

  String body() {
    int from = fork ? 8 : 7;
    boolean closed = action.equals("closed");
    if (kind == Kind.GITLAB) {
      String name =
          switch (action) {
            case "opened" -> "open";
            case "reopened" -> "reopen";
            case "closed" -> "close";
            default -> "update";
          };
      return """
          {"object_kind": "merge_request", "user": {"name": "Contributor"},
           "object_attributes": {"action": "%s", "iid": %d, "state": "%s", "title": "%s",
           "target_branch": "%s", "source_project_id": %d, "target_project_id": 7,
           "target": {"path_with_namespace": "robots/sensors"}, "last_commit": {"id": "%s"}}}"""
          .formatted(name, number, closed ? "closed" : "opened", title, branch, from, head);
    }
    return """
        {"action": "%s", "pull_request": {"number": %d, "state": "%s", "title": "%s",
         "user": {"login": "Contributor"}, "head": {"sha": "%s", "repo": {"id": %d}},
         "base": {"ref": "%s", "repo": {"id": 7, "full_name": "robots/sensors"}}}}"""
        .formatted(
            action.equals("synchronize") && kind == Kind.GITEA ? "synchronized" : action,
            number,
            closed ? "closed" : "open",
            title,
            head,
            from,
            branch);
  }

  /** Sends it as a new message. */
  Api.Answer send(int port, String activity, String secret) {
    return send(port, activity, secret, UUID.randomUUID().toString());
  }

  /**
   * Sends it.
   *
   * @param delivery identifies the message
   */
  Api.Answer send(int port, String activity, String secret, String delivery) {
    return send(port, activity, kind, body(), secret, delivery);
  }

  static Api.Answer send(
      int port, String activity, Kind kind, String body, String secret, String delivery) {
    List<String> headers =
        switch (kind) {
          case GITHUB ->
              List.of(
                  "X-GitHub-Event",
                  "pull_request",
                  "X-GitHub-Delivery",
                  delivery,
                  "X-Hub-Signature-256",
                  "sha256=" + hmac(secret, body));
          case GITLAB ->
              List.of(
                  "X-Gitlab-Event", "Merge Request Hook",
                  "X-Gitlab-Event-UUID", delivery,
                  "X-Gitlab-Token", secret);
          case GITEA ->
              List.of(
                  "X-GitHub-Event",
                  "pull_request",
                  "X-Gitea-Event",
                  "pull_request",
                  "X-Gitea-Delivery",
                  delivery,
                  "X-Gitea-Signature",
                  hmac(secret, body));
        };
    Api sender = new Api(port, null);
    return sender.send(
        sender
            .request("/api/v1/git-hooks/" + activity)
            .headers(headers.toArray(String[]::new))
            .header("Content-Type", "application/json")
            .POST(BodyPublishers.ofString(body)));
  }

  private static String hmac(String secret, String body) {
    try {
      Mac mac = Mac.getInstance("HmacSHA256");
      mac.init(new SecretKeySpec(secret.getBytes(StandardCharsets.UTF_8), "HmacSHA256"));
      return HexFormat.of().formatHex(mac.doFinal(body.getBytes(StandardCharsets.UTF_8)));
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e);
    }
  }
}
