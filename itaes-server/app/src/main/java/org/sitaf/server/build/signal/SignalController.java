package org.sitaf.server.build.signal;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.responses.ApiResponse;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.springframework.http.CacheControl;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/builds/{id}/cases/{no}/signals")
@Tag(name = "recordings")
class SignalController {
  private final StoredSignals signals;

  SignalController(StoredSignals signals) {
    this.signals = signals;
  }

  @GetMapping
  @Operation(
      operationId = "getSignals",
      summary = "Returns the signals of a case over time",
      description =
          "A build stores the signals that its trajectory conditions use, of recorded cases and of"
              + " cases that violate a condition. They are available when the case has finished,"
              + " while the build is still running.")
  @ApiResponse(responseCode = "200")
  @ApiResponse(
      responseCode = "204",
      description = "no signals of the case are stored",
      content = @Content)
  ResponseEntity<CaseSignals> get(@PathVariable String id, @PathVariable int no) {
    return signals
        .find(id, no)
        .map(
            found ->
                ResponseEntity.ok()
                    .cacheControl(CacheControl.noCache().cachePrivate())
                    .eTag(found.sha256())
                    .body(signals.content(found.sha256())))
        .orElseGet(() -> ResponseEntity.noContent().build());
  }
}
