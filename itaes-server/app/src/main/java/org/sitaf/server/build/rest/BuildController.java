package org.sitaf.server.build.rest;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.responses.ApiResponse;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.build.Builds;
import org.sitaf.server.build.agent.WaitingReason;
import org.sitaf.server.build.log.BuildLogs;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Listing;
import org.sitaf.server.web.Sorting;
import org.springframework.http.HttpStatus;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;
import org.springframework.web.context.request.async.DeferredResult;

@RestController
@RequestMapping("/api/v1/builds")
@Tag(name = "builds")
class BuildController {
  private static final Sorting SORTING = Sorting.by("created", "activityName", "model", "priority");
  private static final String SORT =
      "one of created, activityName, model, priority; a leading minus means descending order;"
          + " default -created";

  private static final int MAX_WAIT_S = 60;
  private static final int LOG_EXCERPT = 1 << 20;
  private static final int CASE_LOG = 1 << 18;

  private final Builds builds;
  private final Attempts attempts;
  private final BuildLogs logs;
  private final BuildWaiters waiters;
  private final WaitingReason waiting;

  BuildController(
      Builds builds,
      Attempts attempts,
      BuildLogs logs,
      BuildWaiters waiters,
      WaitingReason waiting) {
    this.builds = builds;
    this.attempts = attempts;
    this.logs = logs;
    this.waiters = waiters;
    this.waiting = waiting;
  }

  @PostMapping
  @Operation(
      operationId = "requestBuild",
      summary = "Requests a build of a suite",
      description =
          "The test application is generated from the current state of the activity and stored with"
              + " the build. A build of some cases has the result of these cases only.")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<BuildView> request(@RequestBody BuildRequest request) {
    if (request.suiteId() == null) {
      throw RequestException.malformed("suiteId must be given.");
    }
    String id =
        request.failedOf() == null
            ? builds.request(request.suiteId(), request.options(), request.source())
            : builds.requestFailed(
                request.suiteId(), request.failedOf(), request.options(), request.source());
    return ResponseEntity.created(URI.create("/api/v1/builds/" + id)).body(view(id));
  }

  @GetMapping
  @Operation(operationId = "listBuilds", summary = "Lists builds, newest first")
  Listing<BuildView> list(
      @RequestParam(required = false) @Nullable String activityId,
      @RequestParam(required = false) BuildView.@Nullable State state,
      @RequestParam(required = false) @Nullable String scheduleId,
      @Parameter(description = "lists the shards of this build; default whole builds only")
          @RequestParam(required = false)
          @Nullable String parentId,
      @Parameter(description = "lists the builds of this commit; -dirty is part of it")
          @RequestParam(required = false)
          @Nullable String commit,
      @Parameter(description = "a part of the activity's or the test model's name; case is ignored")
          @RequestParam(required = false)
          @Nullable String search,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size,
      @Parameter(description = SORT) @RequestParam(required = false) @Nullable String sort) {
    return Listing.of(
        builds.list(
            new Builds.Filter(
                activityId,
                state == null ? null : BuildState.valueOf(state.name()),
                scheduleId,
                parentId,
                commit,
                search),
            Listing.request(page, size, SORTING.order(sort)),
            this::view),
        view -> view);
  }

  @GetMapping("/{id}")
  @Operation(
      operationId = "getBuild",
      summary = "Returns a build",
      description =
          "With waitForChangeSince, the response is sent when the build's version has changed, or"
              + " after timeoutS seconds (at most 60).")
  DeferredResult<BuildView> get(
      @PathVariable String id,
      @RequestParam(required = false) @Nullable Long waitForChangeSince,
      @RequestParam(defaultValue = "20") int timeoutS) {
    int waitS = Math.max(0, Math.min(timeoutS, MAX_WAIT_S));
    DeferredResult<BuildView> response = new DeferredResult<>(Duration.ofSeconds(waitS).toMillis());
    if (waitForChangeSince == null || waitS == 0) {
      response.setResult(view(id));
      return response;
    }
    Runnable respondIfChanged =
        () -> {
          try {
            BuildView current = view(id);
            if (current.version() != waitForChangeSince) {
              response.setResult(current);
            }
          } catch (RequestException e) {
            response.setErrorResult(e);
          }
        };
    response.onTimeout(() -> response.setResult(view(id)));
    response.onCompletion(() -> waiters.remove(id, respondIfChanged));
    // Check after registering, so that no change is missed.
    waiters.add(id, respondIfChanged);
    respondIfChanged.run();
    return response;
  }

  @GetMapping("/{id}/history")
  @Operation(
      operationId = "getBuildHistory",
      summary = "Lists the state changes of a build, oldest first")
  List<BuildView.TransitionView> history(@PathVariable String id) {
    return builds.inspect(
        id, build -> build.transitions().stream().map(BuildView.TransitionView::of).toList());
  }

  @GetMapping("/{id}/attempts")
  @Operation(
      operationId = "listBuildAttempts",
      summary = "Lists the attempts of a build, oldest first",
      description =
          "SUPERSEDED: the result was delivered after the attempt was abandoned, and does not"
              + " count.")
  List<BuildView.AttemptView> attempts(@PathVariable String id) {
    return attempts.of(id).stream().map(BuildView.AttemptView::of).toList();
  }

  @PostMapping("/{id}/cancel")
  @Operation(
      operationId = "cancelBuild",
      summary = "Cancels a build",
      description = "Fails with 409 if it has ended.")
  BuildView cancel(@PathVariable String id) {
    builds.cancel(id, "cancelled by a user");
    return view(id);
  }

  @GetMapping(path = "/{id}/log", produces = MediaType.TEXT_PLAIN_VALUE)
  @Operation(
      operationId = "getBuildLog",
      summary = "Returns a part of a build's log, at most 1 MiB",
      description =
          "offset is in bytes; the header Sitaf-Log-End contains the current end of the log.")
  @ApiResponse(
      responseCode = "200",
      content = @Content(mediaType = "text/plain", schema = @Schema(type = "string")))
  ResponseEntity<byte[]> log(
      @PathVariable String id, @RequestParam(defaultValue = "0") long offset) {
    BuildLogs.Excerpt excerpt = logs.read(id, offset, LOG_EXCERPT);
    return ResponseEntity.ok()
        .contentType(MediaType.parseMediaType("text/plain;charset=UTF-8"))
        .header("Sitaf-Log-End", Long.toString(excerpt.end()))
        .body(excerpt.bytes());
  }

  @GetMapping(path = "/{id}/cases/{no}/log", produces = MediaType.TEXT_PLAIN_VALUE)
  @Operation(
      operationId = "getCaseLog",
      summary = "Returns the log of a case, at most 256 KiB",
      description =
          "The output of the component while the case ran, and the agent's remarks on the case; may"
              + " be empty.")
  @ApiResponse(
      responseCode = "200",
      content = @Content(mediaType = "text/plain", schema = @Schema(type = "string")))
  ResponseEntity<byte[]> caseLog(@PathVariable String id, @PathVariable int no) {
    return ResponseEntity.ok()
        .contentType(MediaType.parseMediaType("text/plain;charset=UTF-8"))
        .body(logs.ofCase(id, no, CASE_LOG));
  }

  private BuildView view(String id) {
    return builds.inspect(id, this::view);
  }

  private BuildView view(Build build) {
    return BuildView.of(build, build.state() == BuildState.QUEUED ? waiting.of(build) : null);
  }
}
