package org.sitaf.server.git.bisection;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.net.URI;
import org.sitaf.server.audit.Audit;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activities/{id}/git/bisections")
@Tag(name = "git")
class BisectionController {
  private final GitBisections bisections;
  private final BisectionViews views;

  BisectionController(GitBisections bisections, BisectionViews views) {
    this.bisections = bisections;
    this.views = views;
  }

  @PostMapping
  @Operation(
      operationId = "beginGitBisection",
      summary = "Searches the first bad commit of an activity's branch",
      description =
          "Between a commit and the last one before that has results, commits are built one after"
              + " another with a low priority, about log2(n) of n commits. They change neither the"
              + " branch nor its history. Commits that cannot be tested are left out. Fails with"
              + " 409 if the branch has a search that runs, or if there is nothing to search.")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<BisectionView> begin(
      @PathVariable String id,
      @RequestBody BisectionRequest request,
      @Parameter(hidden = true) HttpServletRequest http) {
    http.setAttribute(Audit.SUBJECT, http.getRequestURI() + " " + request.checkedCommit());
    GitBisection begun = bisections.begin(id, request);
    return ResponseEntity.created(
            URI.create("/api/v1/activities/" + id + "/git/bisections/" + begun.number()))
        .body(views.of(begun));
  }

  @GetMapping
  @Operation(
      operationId = "listGitBisections",
      summary = "Lists the searches for first bad commits of an activity's branch, newest first")
  Listing<BisectionView> list(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "20") int size) {
    GitBisections.Page found = bisections.list(id, Listing.request(page, size, Sort.unsorted()));
    return new Listing<>(
        found.searches().stream().map(views::of).toList(), page, size, found.total());
  }

  @GetMapping("/{number}")
  @Operation(operationId = "getGitBisection", summary = "Returns a search for the first bad commit")
  BisectionView get(@PathVariable String id, @PathVariable int number) {
    return views.of(bisections.require(id, number));
  }

  @PostMapping("/{number}/cancel")
  @Operation(
      operationId = "cancelGitBisection",
      summary = "Cancels a search for the first bad commit, and its builds")
  BisectionView cancel(@PathVariable String id, @PathVariable int number) {
    return views.of(bisections.cancel(id, number));
  }
}
