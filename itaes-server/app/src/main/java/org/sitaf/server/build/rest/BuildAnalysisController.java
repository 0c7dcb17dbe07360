package org.sitaf.server.build.rest;

import static java.nio.charset.StandardCharsets.UTF_8;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.responses.ApiResponse;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.explain.report.Bundle;
import org.sitaf.core.explain.report.RunRecord;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.build.Analyses;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.BuildKind;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.build.agent.WaitingReason;
import org.sitaf.server.build.analysis.ExplanationView;
import org.sitaf.server.build.analysis.RepetitionView;
import org.sitaf.server.build.analysis.ScoreView;
import org.sitaf.server.error.RequestException;
import org.springframework.http.ContentDisposition;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;
import tools.jackson.databind.json.JsonMapper;

@RestController
@RequestMapping("/api/v1/builds/{id}")
@Tag(name = "analyses")
class BuildAnalysisController {
  private static final int DEFAULT_RUNS = 10;
  private static final String NONE = "none was requested";

  private final Analyses analyses;
  private final WaitingReason waiting;
  private final JsonMapper json;

  BuildAnalysisController(Analyses analyses, WaitingReason waiting, JsonMapper json) {
    this.analyses = analyses;
    this.waiting = waiting;
    this.json = json;
  }

  /** How often the cases are repeated. */
  @Schema(name = "RepetitionRequest")
  record RepetitionRequest(
      @Schema(description = "number of further runs, 1 to 100; default 10")
          @Nullable Integer runs) {}

  /** The id of the build that was requested. */
  @Schema(name = "RequestedBuild")
  record RequestedView(String id) {}

  @PostMapping("/explanation")
  @Operation(
      operationId = "requestExplanation",
      summary = "Requests the causes of the failures of a build",
      description =
          "An agent executes up to 500 further cases. Fails with 409 if no case failed, or if an"
              + " explanation of the build has not ended.")
  @ResponseStatus(HttpStatus.CREATED)
  AnalysisView requestExplanation(@PathVariable String id) {
    return request(id, BuildKind.EXPLANATION);
  }

  @GetMapping("/explanation")
  @Operation(operationId = "getExplanation", summary = "Returns the latest explanation of a build")
  @ApiResponse(responseCode = "200")
  @ApiResponse(responseCode = "204", description = NONE, content = @Content)
  ResponseEntity<AnalysisView> explanation(@PathVariable String id) {
    return found(id, BuildKind.EXPLANATION);
  }

  @PostMapping("/score")
  @Operation(
      operationId = "requestScore",
      summary = "Requests the score of the specification that a build tested",
      description =
          "An agent puts faults between test driver and component, and counts those that the cases"
              + " notice. Fails with 409 if a score of the build has not ended.")
  @ResponseStatus(HttpStatus.CREATED)
  AnalysisView requestScore(@PathVariable String id) {
    return request(id, BuildKind.SCORE);
  }

  @GetMapping("/score")
  @Operation(operationId = "getScore", summary = "Returns the latest score of a build")
  @ApiResponse(responseCode = "200")
  @ApiResponse(responseCode = "204", description = NONE, content = @Content)
  ResponseEntity<AnalysisView> score(@PathVariable String id) {
    return found(id, BuildKind.SCORE);
  }

  @PostMapping("/repetition")
  @Operation(
      operationId = "requestRepetition",
      summary = "Requests further runs of the cases of a build",
      description =
          "An agent executes the cases in new processes, and finds those whose verdicts or values"
              + " differ between the runs. Fails with 409 if a repetition of the build has not"
              + " ended.")
  @ResponseStatus(HttpStatus.CREATED)
  AnalysisView requestRepetition(
      @PathVariable String id, @RequestBody(required = false) @Nullable RepetitionRequest request) {
    analyses.repeat(id, request == null || request.runs() == null ? DEFAULT_RUNS : request.runs());
    return requested(id, BuildKind.REPETITION);
  }

  @GetMapping("/repetition")
  @Operation(operationId = "getRepetition", summary = "Returns the latest repetition of a build")
  @ApiResponse(responseCode = "200")
  @ApiResponse(responseCode = "204", description = NONE, content = @Content)
  ResponseEntity<AnalysisView> repetition(@PathVariable String id) {
    return found(id, BuildKind.REPETITION);
  }

  @PostMapping("/explanation/causes/{no}/run")
  @Operation(
      operationId = "runSimplestCase",
      summary = "Requests a build of the simplest case of a cause",
      description = "The case has the number that follows those of the suite.")
  @ResponseStatus(HttpStatus.CREATED)
  RequestedView run(
      @PathVariable String id,
      @Parameter(description = "position of the cause in the explanation, from 1") @PathVariable
          int no) {
    ExplanationView.CauseView cause = cause(id, no);
    return new RequestedView(
        analyses.run(
            id, (model, suite, next) -> Bundle.simplest(model, suite, cause.toCause(), next)));
  }

  @GetMapping(path = "/explanation/causes/{no}/bundle", produces = "application/zip")
  @Operation(
      operationId = "getBundle",
      summary = "Returns a zip with the activity and the simplest case of a cause",
      description = "./sitaf replay runs the case and compares its outcome.")
  @ApiResponse(
      responseCode = "200",
      content =
          @Content(
              mediaType = "application/zip",
              schema = @Schema(type = "string", format = "binary")))
  ResponseEntity<byte[]> bundle(
      @PathVariable String id,
      @Parameter(description = "position of the cause in the explanation, from 1") @PathVariable
          int no) {
    ExplanationView.CauseView cause = cause(id, no);
    TestApplication application = analyses.application(id);
    TestSuite only =
        Bundle.simplest(application.model(), application.suite(), cause.toCause(), 1)
            .filter(suite -> !cause.record().isEmpty())
            .orElseThrow(() -> RequestException.conflict("The cause has no bundle."));
    String name = application.model().name() + "-" + no + ".zip";
    byte[] record =
        json.writerWithDefaultPrettyPrinter()
            .writeValueAsString(
                Bundle.record(
                    application.model(), application.suite(), new RunRecord(cause.records())))
            .getBytes(UTF_8);
    String readme =
        Bundle.readme(
            application.activity().profile().name(),
            application.model().name(),
            cause.toCause(),
            ExplanationView.SENTENCES,
            name);
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    try {
      ActivityArchive.write(
          Bundle.files(application.activity().files(), only, record, readme), zip);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return ResponseEntity.ok()
        .header(
            HttpHeaders.CONTENT_DISPOSITION,
            ContentDisposition.attachment().filename(name).build().toString())
        .body(zip.toByteArray());
  }

  private ExplanationView.CauseView cause(String id, int no) {
    ExplanationView explanation =
        latest(id, BuildKind.EXPLANATION).map(AnalysisView::explanation).orElse(null);
    if (explanation == null || no < 1 || no > explanation.causes().size()) {
      throw RequestException.notFound(
          "cause in the explanation of build " + id, Integer.toString(no));
    }
    return explanation.causes().get(no - 1);
  }

  private AnalysisView request(String id, BuildKind kind) {
    analyses.request(id, kind);
    return requested(id, kind);
  }

  private AnalysisView requested(String id, BuildKind kind) {
    return latest(id, kind).orElseThrow();
  }

  private ResponseEntity<AnalysisView> found(String id, BuildKind kind) {
    return latest(id, kind)
        .map(ResponseEntity::ok)
        .orElseGet(() -> ResponseEntity.noContent().build());
  }

  private Optional<AnalysisView> latest(String id, BuildKind kind) {
    return analyses.latest(id, kind, this::view);
  }

  private AnalysisView view(Build analysis, byte @Nullable [] report) {
    return AnalysisView.of(
        analysis,
        analysis.state() == BuildState.QUEUED ? waiting.of(analysis) : null,
        report == null ? null : json.readValue(report, documentOf(analysis.kind())));
  }

  private static Class<?> documentOf(BuildKind kind) {
    return switch (kind) {
      case EXPLANATION -> ExplanationView.class;
      case SCORE -> ScoreView.class;
      case REPETITION -> RepetitionView.class;
      case TEST -> throw new IllegalArgumentException("a test is not an analysis");
    };
  }
}
