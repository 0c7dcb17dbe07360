package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.io.ByteArrayOutputStream;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.JunitXml;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.Sort;
import org.springframework.http.MediaType;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/builds/{id}/result")
@Tag(name = "results")
class ResultController {
  private final Results results;

  ResultController(Results results) {
    this.results = results;
  }

  @GetMapping
  @Operation(
      operationId = "getResult",
      summary = "Returns the result of a build, without its cases")
  ResultView get(@PathVariable String id) {
    return ResultView.of(results.overview(id));
  }

  @GetMapping("/cases")
  @Operation(
      operationId = "listResultCases",
      summary = "Lists the cases of a result by number",
      description = "Can be filtered by verdict, and by the value of a parameter.")
  Listing<CaseView> cases(
      @PathVariable String id,
      @RequestParam(required = false) @Nullable Verdict verdict,
      @RequestParam(required = false) @Nullable String parameter,
      @RequestParam(required = false) @Nullable String value,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    if (parameter != null && value != null) {
      return Listing.of(
          results.casesWithValue(
              id, verdict, parameter, value, Listing.request(page, size, Sort.unsorted())),
          CaseView::of);
    }
    return Listing.of(
        results.cases(id, verdict, Listing.request(page, size, Sort.unsorted())), CaseView::of);
  }

  @GetMapping(path = "/document", produces = MediaType.APPLICATION_XML_VALUE)
  @Operation(
      operationId = "getResultDocument",
      summary = "Returns the document of a result (test_result_descriptor) as the agent sent it")
  byte[] document(@PathVariable String id) {
    return results.document(id);
  }

  @GetMapping(path = "/junit", produces = MediaType.APPLICATION_XML_VALUE)
  @Operation(operationId = "getResultAsJunit", summary = "Exports a result as JUnit XML")
  byte[] junit(@PathVariable String id) {
    ByteArrayOutputStream xml = new ByteArrayOutputStream();
    JunitXml.write(results.activityName(id), List.of(Results.read(results.document(id))), xml);
    return xml.toByteArray();
  }
}
