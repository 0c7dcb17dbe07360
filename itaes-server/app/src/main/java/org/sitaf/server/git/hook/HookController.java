package org.sitaf.server.git.hook;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.parameters.RequestBody;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.io.InputStream;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.Fetches;
import org.sitaf.server.git.request.GitRequests;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.springframework.http.HttpStatus;
import org.springframework.http.MediaType;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Anyone can send messages here; only those with the right signature do something. */
@RestController
@RequestMapping("/api/v1/git-hooks")
@Tag(name = "git")
class HookController {
  private final GitSources sources;
  private final Deliveries deliveries;
  private final Fetches fetches;
  private final GitRequests requests;
  private final JsonMapper json;

  HookController(
      GitSources sources,
      Deliveries deliveries,
      Fetches fetches,
      GitRequests requests,
      JsonMapper json) {
    this.sources = sources;
    this.deliveries = deliveries;
    this.fetches = fetches;
    this.requests = requests;
    this.json = json;
  }

  @PostMapping(path = "/{id}", consumes = MediaType.APPLICATION_JSON_VALUE)
  @Operation(
      operationId = "receiveGitHook",
      summary = "Receives a message of GitHub, GitLab, Gitea or Forgejo",
      description =
          "A push to the activity's branch, and to a pull or merge request into it, is fetched at"
              + " once. A request from a fork is only listed. A message that was received before"
              + " does nothing. Fails with 403 if the signature is wrong.",
      requestBody =
          @RequestBody(
              required = true,
              content =
                  @Content(
                      mediaType = MediaType.APPLICATION_JSON_VALUE,
                      schema = @Schema(type = "object"))))
  @ResponseStatus(HttpStatus.ACCEPTED)
  void receive(@PathVariable String id, @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    HookMessage message;
    try (InputStream in = request.getInputStream()) {
      message = new HookMessage(in.readAllBytes(), request::getHeader);
    }
    String secret = sources.hookSecret(id).orElse(null);
    if (secret == null || !message.isSignedWith(secret)) {
      throw RequestException.forbidden(
          "The signature is wrong, or the activity expects no messages. Create the secret of the"
              + " activity's Git source again, and enter it at the forge.");
    }
    GitSource source = sources.require(id);
    if (!deliveries.isNew(source.id(), message.id())) {
      return;
    }
    if (message.isPush() && source.reference().equals(body(message).path("ref").asString(""))) {
      fetches.request(source.id());
    } else if (message.isRequest()) {
      RequestMessage.parse(message.forge(), body(message))
          .ifPresent(reported -> requests.report(source, reported));
    }
  }

  private JsonNode body(HookMessage message) {
    try {
      return json.readTree(message.body());
    } catch (JacksonException e) {
      throw RequestException.malformed("The body is no JSON: " + e.getOriginalMessage() + ".");
    }
  }
}
