package org.sitaf.server.result.live;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.sitaf.server.result.CaseView;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.Sort;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/builds/{id}/cases")
@Tag(name = "results")
class LiveCaseController {
  private final LiveCases cases;

  LiveCaseController(LiveCases cases) {
    this.cases = cases;
  }

  @GetMapping
  @Operation(
      operationId = "listLiveCases",
      summary = "Cases that have ended, in the order in which they did, while a build runs",
      description =
          "Gone as soon as the build has its result; a build that was cancelled or failed keeps"
              + " them. Long literals and messages are cut.")
  Listing<CaseView> list(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    return Listing.of(cases.page(id, Listing.request(page, size, Sort.unsorted())), CaseView::of);
  }
}
