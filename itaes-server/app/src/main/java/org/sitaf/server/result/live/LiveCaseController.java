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
      summary = "Lists the finished cases of a running build in the order in which they finished",
      description =
          "The list is deleted when the build has its result; builds that were cancelled or failed"
              + " keep it. Long literals and messages are truncated.")
  Listing<CaseView> list(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    return Listing.of(cases.page(id, Listing.request(page, size, Sort.unsorted())), CaseView::of);
  }
}
