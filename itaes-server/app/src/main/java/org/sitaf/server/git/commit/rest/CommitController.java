package org.sitaf.server.git.commit.rest;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.List;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.Fetches;
import org.sitaf.server.git.commit.GitCommit;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activities/{id}/git")
@Tag(name = "git")
class CommitController {
  private final GitSources sources;
  private final CommitRows commits;
  private final CommitViews views;
  private final Fetches fetches;

  CommitController(GitSources sources, CommitRows commits, CommitViews views, Fetches fetches) {
    this.sources = sources;
    this.commits = commits;
    this.views = views;
    this.fetches = fetches;
  }

  @PostMapping("/fetch")
  @Operation(
      operationId = "fetchGitSource",
      summary = "Looks for new commits now",
      description = "Returns at once; the source shows when it was fetched, or why it was not.")
  @ResponseStatus(HttpStatus.ACCEPTED)
  void fetch(@PathVariable String id) {
    fetches.request(sources.require(id).id());
  }

  @GetMapping("/commits")
  @Operation(
      operationId = "listGitCommits",
      summary =
          "Lists the commits of an activity's branch or a request with their results, newest first")
  Listing<CommitView> list(
      @PathVariable String id,
      @Parameter(description = "number of a pull or merge request; default 0, the branch")
          @RequestParam(defaultValue = "0")
          int request,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    PageRequest pageRequest = Listing.request(page, size, Sort.unsorted());
    if (request < 0) {
      throw RequestException.malformed("request: must be 0 or more, not " + request + ".");
    }
    GitSource source = sources.require(id);
    List<GitCommit> found =
        commits.list(source.id(), request, pageRequest.getPageSize(), pageRequest.getOffset());
    return new Listing<>(views.of(found), page, size, commits.count(source.id(), request));
  }

  @GetMapping("/commits/{sha}")
  @Operation(operationId = "getGitCommit", summary = "Returns a commit with its results")
  CommitView get(@PathVariable String id, @PathVariable String sha) {
    GitSource source = sources.require(id);
    GitCommit commit =
        commits.find(source.id(), sha).orElseThrow(() -> RequestException.notFound("commit", sha));
    return views.of(List.of(commit)).get(0);
  }
}
