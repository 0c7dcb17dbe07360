package org.sitaf.server.git.request;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.audit.Audit;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.rest.CommitView;
import org.sitaf.server.git.commit.rest.CommitViews;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activities/{id}/git/requests")
@Tag(name = "git")
class RequestController {
  private final GitRequests requests;
  private final CommitRows commits;
  private final CommitViews views;

  RequestController(GitRequests requests, CommitRows commits, CommitViews views) {
    this.requests = requests;
    this.commits = commits;
    this.views = views;
  }

  @GetMapping
  @Operation(
      operationId = "listGitRequests",
      summary =
          "Lists the pull or merge requests into an activity's branch, the highest number first",
      description = "Those that the forge has reported by webhook.")
  Listing<RequestView> list(
      @PathVariable String id,
      @Parameter(description = "default: all") @RequestParam(required = false)
          GitRequest.@Nullable State state,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    GitRequests.Found found =
        requests.list(id, state, Listing.request(page, size, Sort.unsorted()));
    return new Listing<>(views(found.requests()), page, size, found.total());
  }

  @GetMapping("/{number}")
  @Operation(
      operationId = "getGitRequest",
      summary = "Returns a pull or merge request with the results of its newest commit")
  RequestView get(@PathVariable String id, @PathVariable int number) {
    return views(List.of(requests.require(id, number))).get(0);
  }

  @Schema(name = "GitRequestBuild")
  record Approved(
      @Schema(description = "the head that the caller has looked at: 40 hexadecimal digits")
          String head) {}

  @PostMapping("/{number}/build")
  @Operation(
      operationId = "buildGitRequest",
      summary = "Fetches and builds the head of a pull or merge request",
      description =
          "Returns at once. The head of a fork is fetched and built only after this request, since"
              + " its code runs on the agents; a new push needs a new one. Other heads are built"
              + " again. Fails with 409 if the request has another head than the given one.")
  @ResponseStatus(HttpStatus.ACCEPTED)
  RequestView build(
      @PathVariable String id,
      @PathVariable int number,
      @RequestBody Approved approved,
      @Parameter(hidden = true) HttpServletRequest request) {
    String head = ReportedRequest.requireSha("head", approved.head());
    // The audit log says which code somebody let run.
    request.setAttribute(Audit.SUBJECT, request.getRequestURI() + " " + head);
    return views(List.of(requests.build(id, number, head))).get(0);
  }

  private List<RequestView> views(List<GitRequest> found) {
    if (found.isEmpty()) {
      return List.of();
    }
    Map<Integer, CommitView> heads =
        views
            .of(
                commits.heads(
                    found.get(0).sourceId(), found.stream().map(GitRequest::number).toList()))
            .stream()
            .collect(Collectors.toMap(CommitView::request, Function.identity()));
    return found.stream()
        .map(request -> RequestView.of(request, heads.get(request.number())))
        .toList();
  }
}
