package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.Sort;
import org.springframework.http.MediaType;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** Statistics, comparisons, exports and the history of results. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "results")
class AnalysisController {
  private final Results results;

  AnalysisController(Results results) {
    this.results = results;
  }

  @GetMapping("/builds/{id}/result/statistics")
  @Operation(
      operationId = "getResultStatistics",
      summary = "Returns processing times, and verdicts by parameter value")
  StatisticsView statistics(@PathVariable String id) {
    return StatisticsView.of(results.load(id));
  }

  @GetMapping("/builds/{id}/result/failures")
  @Operation(
      operationId = "getResultFailures",
      summary = "Returns what failed, in groups of equal messages, and since which build")
  FailuresView failures(@PathVariable String id) {
    return results.failures(id);
  }

  @GetMapping("/builds/{id}/result/comparison")
  @Operation(
      operationId = "compareResults",
      summary = "Compares a result with that of another build")
  ComparisonView comparison(@PathVariable String id, @RequestParam String with) {
    return ComparisonView.of(results.load(with), results.load(id));
  }

  @GetMapping(path = "/builds/{id}/result/cases.csv", produces = "text/csv")
  @Operation(operationId = "getResultAsCsv", summary = "Exports a result as CSV")
  byte[] csv(@PathVariable String id) {
    return ResultCsv.write(results.load(id));
  }

  @GetMapping(path = "/builds/{id}/result/report", produces = MediaType.TEXT_HTML_VALUE)
  @Operation(operationId = "getResultReport", summary = "Exports a result as a single HTML page")
  byte[] report(@PathVariable String id) {
    return ResultReport.write(results.activityName(id), results.load(id));
  }

  @GetMapping("/activities/{id}/results")
  @Operation(
      operationId = "listResults",
      summary = "Lists the results of an activity, newest first")
  Listing<HistoryView> history(
      @PathVariable String id,
      @RequestParam(required = false) @Nullable String model,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    return Listing.of(
        results.history(id, model, Listing.request(page, size, Sort.unsorted())), HistoryView::of);
  }
}
