package org.sitaf.server.comparison;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.Difference;
import org.sitaf.server.comparison.ValueComparisonView.DifferenceView;
import org.sitaf.server.comparison.ValueComparisonView.NotComparableView;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.Sort;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/builds/{id}/result/comparison")
@Tag(name = "results")
class ComparisonController {
  private static final String OTHER = "build with the earlier result";

  private final Comparisons comparisons;

  ComparisonController(Comparisons comparisons) {
    this.comparisons = comparisons;
  }

  /** The lists of a comparison. */
  enum Part {
    differences,
    lastBits,
    slower
  }

  @GetMapping("/values")
  @Operation(
      operationId = "compareValues",
      summary = "Compares the values of a result with those of another build",
      description =
          "As ./sitaf compare does, but with results that exist: differences are not confirmed by"
              + " further runs. Cases with the same inputs are the same case. Fails with 409 if the"
              + " parameters differ.")
  ValueComparisonView values(
      @PathVariable String id, @Parameter(description = OTHER) @RequestParam String with) {
    return ValueComparisonView.of(comparisons.of(with, id));
  }

  @GetMapping("/differences")
  @Operation(
      operationId = "listDifferences",
      summary = "Lists the differences between the values of two results",
      description = "In the order of the cases.")
  Listing<DifferenceView> differences(
      @PathVariable String id,
      @Parameter(description = OTHER) @RequestParam String with,
      @Parameter(description = "slower: base and now are medians in microseconds")
          @RequestParam(defaultValue = "differences")
          Part part,
      @Parameter(description = "index of a group of differences; default all")
          @RequestParam(required = false)
          @Nullable Integer group,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    var pages = Listing.request(page, size, Sort.unsorted());
    ComparedBuilds compared = comparisons.of(with, id);
    return Listing.of(
        list(compared, part, group), pages, found -> DifferenceView.of(found, compared));
  }

  private static List<Difference> list(
      ComparedBuilds compared, Part part, @Nullable Integer group) {
    if (group != null) {
      if (part != Part.differences) {
        throw RequestException.malformed("group: only differences have groups.");
      }
      if (group < 0 || group >= compared.groups().size()) {
        throw RequestException.notFound("group of differences", group.toString());
      }
      return compared.groups().get(group).differences();
    }
    return switch (part) {
      case differences -> compared.differences();
      case lastBits -> compared.lastBits();
      case slower -> compared.slower();
    };
  }

  @GetMapping("/not-comparable")
  @Operation(
      operationId = "listNotComparable",
      summary = "Lists what only one of two results has, or could not be executed")
  Listing<NotComparableView> notComparable(
      @PathVariable String id,
      @Parameter(description = OTHER) @RequestParam String with,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    var pages = Listing.request(page, size, Sort.unsorted());
    return Listing.of(comparisons.of(with, id).notComparable(), pages, NotComparableView::of);
  }
}
