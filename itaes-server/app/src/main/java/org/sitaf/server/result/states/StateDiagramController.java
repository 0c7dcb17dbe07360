package org.sitaf.server.result.states;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.result.Results;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/builds/{id}/result/states")
@Tag(name = "results")
class StateDiagramController {
  private final Results results;
  private final StateDiagrams diagrams;

  StateDiagramController(Results results, StateDiagrams diagrams) {
    this.results = results;
    this.diagrams = diagrams;
  }

  @GetMapping
  @Operation(
      operationId = "getStateDiagram",
      summary = "Returns the abstract states of a sequence and the steps between them")
  StateDiagramView get(@PathVariable String id) {
    TestResult result = results.load(id);
    boolean sequences = result.cases().stream().anyMatch(c -> !c.steps().isEmpty());
    return sequences
        ? diagrams.of(id, result).orElse(StateDiagramView.NONE)
        : StateDiagramView.NONE;
  }
}
