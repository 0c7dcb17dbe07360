package org.sitaf.server.history;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activities/{id}/case-history")
@Tag(name = "results")
class CaseHistoryController {
  /** An item has all values of a case. */
  private static final int MAX_SIZE = 200;

  private final CaseHistories histories;

  CaseHistoryController(CaseHistories histories) {
    this.histories = histories;
  }

  @GetMapping
  @Operation(
      operationId = "getCaseHistory",
      summary = "Returns what a case did in all commits of the branch, or in all builds",
      description =
          "The case is given by its number in a build. In other builds the case with the same"
              + " inputs is the same case, whatever its number is.")
  CaseHistoryView get(
      @PathVariable String id,
      @Parameter(description = "name of the test model") @RequestParam String model,
      @Parameter(description = "number of the case in the build, from 1") @RequestParam int no,
      @Parameter(description = "default: the build of the model with the newest result")
          @RequestParam(required = false)
          @Nullable String build,
      @Parameter(description = "default: commits if the activity comes from Git, else builds")
          @RequestParam(required = false)
          CaseHistories.@Nullable Points by,
      @RequestParam(defaultValue = "0") int page,
      @Parameter(description = "at most 200") @RequestParam(defaultValue = "100") int size) {
    if (size > MAX_SIZE) {
      throw RequestException.malformed("size must be 1 to " + MAX_SIZE + ", not " + size + ".");
    }
    if (no < 1) {
      throw RequestException.malformed("no must be the number of a case, from 1, not " + no + ".");
    }
    PageRequest pages = Listing.request(page, size, Sort.unsorted());
    return CaseHistoryView.of(
        histories.of(new CaseHistories.Request(id, model, build, no, by), size, pages.getOffset()),
        page,
        size);
  }
}
