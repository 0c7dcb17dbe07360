package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.suite.SuiteView.CaseView;
import org.sitaf.server.web.Listing;
import org.sitaf.server.web.Requests;
import org.sitaf.server.web.Sorting;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestHeader;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1")
@Tag(name = "suites")
class SuiteController {
  private static final Sorting SORTING = Sorting.by("created", "model", "name");
  private static final String SORT =
      "one of created, model, name; a leading minus means descending order; default -created";

  private final Suites suites;
  private final Requests requests;

  SuiteController(Suites suites, Requests requests) {
    this.suites = suites;
    this.requests = requests;
  }

  @PostMapping("/activities/{id}/models/{name}/suites")
  @Operation(operationId = "generateSuite", summary = "Generates a suite from a model")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<SuiteView> generate(
      @PathVariable String id,
      @PathVariable String name,
      @RequestBody(required = false) @Nullable SuiteOptions options) {
    SuiteOptions given = options == null ? SuiteOptions.NONE : options;
    String suiteId = suites.generate(id, name, given.toGeneration());
    return ResponseEntity.created(URI.create("/api/v1/suites/" + suiteId)).body(get(suiteId));
  }

  @GetMapping("/activities/{id}/suites")
  @Operation(operationId = "listSuites", summary = "Lists the suites of an activity, newest first")
  Listing<SuiteView> list(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size,
      @Parameter(description = SORT) @RequestParam(required = false) @Nullable String sort) {
    return Listing.of(
        suites.ofActivity(id, Listing.request(page, size, SORTING.order(sort)), suites::view),
        view -> view);
  }

  @GetMapping("/suites/{id}")
  @Operation(operationId = "getSuite", summary = "Returns a suite")
  SuiteView get(@PathVariable String id) {
    return suites.inspect(id, suites::view);
  }

  @GetMapping("/suites/{id}/cases")
  @Operation(operationId = "listSuiteCases", summary = "Lists the cases of a suite by number")
  Listing<CaseView> cases(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    TestSuite suite = suites.suite(id);
    return Listing.of(
        suite.cases(),
        Listing.request(page, size, Sort.unsorted()),
        testCase -> CaseView.of(testCase, suite));
  }

  @GetMapping(path = "/suites/{id}/document", produces = MediaType.APPLICATION_XML_VALUE)
  @Operation(
      operationId = "getSuiteDocument",
      summary = "Returns the document of a suite (test_suite_data)")
  ResponseEntity<byte[]> document(@PathVariable String id) {
    StoredSuite stored = suites.find(id);
    return ResponseEntity.ok()
        .contentType(MediaType.APPLICATION_XML)
        .eTag(Long.toString(stored.version()))
        .body(suites.document(id));
  }

  @PutMapping(path = "/suites/{id}/document", consumes = MediaType.APPLICATION_XML_VALUE)
  @Operation(
      operationId = "replaceSuiteDocument",
      summary = "Replaces the document of a suite",
      description = "For edited expected values or custom cases.",
      requestBody =
          @io.swagger.v3.oas.annotations.parameters.RequestBody(
              required = true,
              content =
                  @Content(
                      mediaType = MediaType.APPLICATION_XML_VALUE,
                      schema = @Schema(type = "string"))))
  SuiteView replaceDocument(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    try (InputStream body = requests.body(request)) {
      suites.replaceDocument(id, body.readAllBytes(), Requests.expected(ifMatch));
    }
    return get(id);
  }

  @GetMapping("/suites/{id}/harness")
  @Operation(
      operationId = "getHarness",
      summary = "Returns the generated sources of a suite's test application")
  List<HarnessFile> harness(@PathVariable String id) {
    return HarnessFile.of(suites.application(id, RosImplementation.INCLUDED));
  }
}
