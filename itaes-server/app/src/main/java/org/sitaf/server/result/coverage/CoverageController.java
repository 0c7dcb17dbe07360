package org.sitaf.server.result.coverage;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.Optional;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.result.Results;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/builds/{id}/result/coverage")
@Tag(name = "results")
class CoverageController {
  private final Results results;
  private final BuiltSources sources;

  CoverageController(Results results, BuiltSources sources) {
    this.results = results;
    this.sources = sources;
  }

  @GetMapping
  @Operation(operationId = "getCoverage", summary = "Returns the coverage of the component by file")
  CoverageView get(@PathVariable String id) {
    return results.coverage(id).map(CoverageView::of).orElse(CoverageView.NOT_MEASURED);
  }

  @GetMapping("/source")
  @Operation(
      operationId = "getCoverageSource",
      summary = "Returns a source file of the component with the coverage of its lines")
  CoverageView.SourceView source(
      @PathVariable String id,
      @Parameter(description = "path of the file in the coverage") @RequestParam String path) {
    Optional<Coverage.File> file =
        results.coverage(id).stream()
            .flatMap(c -> c.files().stream())
            .filter(f -> f.path().equals(path))
            .findFirst();
    return file.map(f -> CoverageView.SourceView.of(f, sources.text(id, path).orElse(null)))
        .orElseThrow(() -> RequestException.notFound("coverage of a source in build " + id, path));
  }
}
