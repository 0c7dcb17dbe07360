package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.SuiteCsv;
import org.sitaf.server.computation.Computations;
import org.sitaf.server.suite.SuiteEdits.ExpectedChanges;
import org.sitaf.server.suite.SuiteEdits.ExpectedFill;
import org.sitaf.server.web.Requests;
import org.springframework.http.HttpHeaders;
import org.springframework.http.MediaType;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestHeader;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;
import tools.jackson.databind.json.JsonMapper;

/** Operations for editing the cases of a suite. */
@RestController
@RequestMapping("/api/v1/suites/{id}")
@Tag(name = "suites")
class SuiteEditController {
  private static final String CSV = "text/csv";

  private final Suites suites;
  private final Requests requests;
  private final JsonMapper json;
  private final Computations computations;

  SuiteEditController(
      Suites suites, Requests requests, JsonMapper json, Computations computations) {
    this.computations = computations;
    this.suites = suites;
    this.requests = requests;
    this.json = json;
  }

  @PatchMapping("/expected")
  @Operation(operationId = "changeExpected", summary = "Sets expected values of single cases")
  SuiteView change(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @RequestBody ExpectedChanges changes) {
    return edit(id, ifMatch, (suite, model) -> SuiteEdits.change(suite, model, changes));
  }

  @PostMapping("/expected/fill")
  @Operation(
      operationId = "fillExpected",
      summary = "Computes expected values with a formula",
      description = "Nothing is changed if the formula has no value for a case.")
  SuiteView fill(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @RequestBody ExpectedFill fill) {
    return edit(
        id,
        ifMatch,
        (suite, model) ->
            computations.generation("The formula", () -> SuiteEdits.fill(suite, model, fill)));
  }

  @PostMapping("/undo")
  @Operation(
      operationId = "undoSuiteChange",
      summary = "Undoes the latest change of a suite",
      description = "Fails with 409 if there is no change to undo.")
  SuiteView undo(@PathVariable String id, @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch) {
    suites.undo(id, Requests.expected(ifMatch));
    return suites.inspect(id, suites::view);
  }

  @GetMapping(path = "/cases.csv", produces = CSV)
  @Operation(operationId = "exportSuiteAsCsv", summary = "Exports the cases as CSV")
  byte[] csv(@PathVariable String id) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    SuiteCsv.write(suites.suite(id), out);
    return out.toByteArray();
  }

  @PutMapping(path = "/cases.csv", consumes = CSV)
  @Operation(
      operationId = "importSuiteFromCsv",
      summary = "Replaces the cases of a suite with those of a CSV document",
      description = "The header must be that of the export.",
      requestBody =
          @io.swagger.v3.oas.annotations.parameters.RequestBody(
              required = true,
              content = @Content(mediaType = CSV, schema = @Schema(type = "string"))))
  SuiteView importCsv(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    byte[] document = body(request);
    return edit(id, ifMatch, (suite, model) -> fromCsv(document, suite));
  }

  @GetMapping(path = "/cases.json", produces = MediaType.APPLICATION_OCTET_STREAM_VALUE)
  @Operation(operationId = "exportSuiteAsJson", summary = "Exports the cases as JSON")
  byte[] json(@PathVariable String id) {
    return SuiteJson.write(suites.suite(id), json);
  }

  @PutMapping(path = "/cases.json", consumes = MediaType.APPLICATION_OCTET_STREAM_VALUE)
  @Operation(
      operationId = "importSuiteFromJson",
      summary = "Replaces the cases of a suite with those of a JSON document",
      requestBody =
          @io.swagger.v3.oas.annotations.parameters.RequestBody(
              required = true,
              content =
                  @Content(
                      mediaType = MediaType.APPLICATION_OCTET_STREAM_VALUE,
                      schema = @Schema(type = "string"))))
  SuiteView importJson(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    byte[] document = body(request);
    return edit(id, ifMatch, (suite, model) -> SuiteJson.read(document, suite, json));
  }

  @GetMapping("/combinations")
  @Operation(
      operationId = "getCombinations",
      summary = "Returns which pairs of values occur in the cases",
      description =
          "With first and second, also the number of cases for each pair of values of these two"
              + " parameters.")
  CombinationsView combinations(
      @PathVariable String id,
      @RequestParam(required = false) @Nullable Integer first,
      @RequestParam(required = false) @Nullable Integer second) {
    return CombinationsView.of(suites.suite(id), first, second);
  }

  @GetMapping("/changes")
  @Operation(
      operationId = "getSuiteChanges",
      summary = "Compares a suite with the previous suite of the same model")
  ChangesView changes(@PathVariable String id) {
    StoredSuite stored = suites.find(id);
    return suites
        .previous(stored)
        .map(p -> ChangesView.between(p.id(), suites.suite(p), suites.suite(stored)))
        .orElseGet(ChangesView::first);
  }

  private SuiteView edit(String id, String ifMatch, Suites.Edit edit) {
    suites.edit(id, Requests.expected(ifMatch), edit);
    return suites.inspect(id, suites::view);
  }

  private static TestSuite fromCsv(byte[] document, TestSuite suite) {
    try {
      return SuiteCsv.read(new ByteArrayInputStream(document), "the CSV document", suite);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private byte[] body(HttpServletRequest request) throws IOException {
    try (InputStream body = requests.body(request)) {
      return body.readAllBytes();
    }
  }
}
