package org.sitaf.server.git.source;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import org.sitaf.server.web.Requests;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestHeader;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1")
@Tag(name = "git")
class SourceController {
  private final GitSources sources;

  SourceController(GitSources sources) {
    this.sources = sources;
  }

  @Schema(name = "GitActivity")
  record Created(@Schema(description = "of the activity") String id) {}

  @PostMapping("/git-activities")
  @Operation(
      operationId = "createActivityFromGit",
      summary = "Creates an activity from a folder of a Git branch",
      description =
          "The repository is fetched before the answer. Nothing is stored if it cannot be fetched"
              + " (409) or the folder is no activity (422).")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<Created> create(@RequestBody SourceRequest request) {
    String id = sources.createActivity(request);
    return ResponseEntity.created(URI.create("/api/v1/activities/" + id)).body(new Created(id));
  }

  @GetMapping("/activities/{id}/git")
  @Operation(operationId = "getGitSource", summary = "Returns the Git source of an activity")
  SourceView get(@PathVariable String id) {
    return SourceView.of(sources.require(id));
  }

  @PutMapping("/activities/{id}/git")
  @Operation(
      operationId = "saveGitSource",
      summary = "Sets the Git source of an activity",
      description =
          "The branch is fetched soon, and its files replace those of the activity. If-Match is"
              + " the version of the source, or * for the first one.")
  SourceView save(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @RequestBody SourceRequest request) {
    return SourceView.of(sources.save(id, request, Requests.expected(ifMatch)));
  }

  @Schema(name = "GitHook")
  record Hook(
      @Schema(description = "where the forge sends its messages, after the server's address")
          String path,
      @Schema(description = "signs the messages; shown only once") String secret) {}

  @PostMapping("/activities/{id}/git/hook")
  @Operation(
      operationId = "createGitHook",
      summary = "Creates the secret with which a forge signs its messages",
      description = "A former secret is no longer accepted.")
  @ResponseStatus(HttpStatus.CREATED)
  Hook hook(@PathVariable String id) {
    return new Hook("/api/v1/git-hooks/" + id, sources.createHookSecret(id));
  }

  @DeleteMapping("/activities/{id}/git")
  @Operation(
      operationId = "deleteGitSource",
      summary = "Removes the Git source of an activity",
      description = "The activity keeps its files and results, and loses its list of commits.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    sources.delete(id);
  }
}
