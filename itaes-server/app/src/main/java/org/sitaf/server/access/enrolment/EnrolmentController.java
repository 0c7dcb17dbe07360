package org.sitaf.server.access.enrolment;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1")
@Tag(name = "enrolments")
class EnrolmentController {
  private static final int MOST_USES = 10_000;
  private static final int MOST_HOURS = 30 * 24;

  private final Enrolments enrolments;

  EnrolmentController(Enrolments enrolments) {
    this.enrolments = enrolments;
  }

  @Schema(name = "EnrolmentRequest")
  record EnrolmentRequest(
      @Schema(
              description =
                  "the only agent that may use it, in the place of one of that name; absent for any"
                      + " agent that is not known yet")
          @Nullable String agent,
      @Schema(description = "how many agents it lets in, 1 to 10000") int uses,
      @Schema(description = "for how long, 1 to 720") int hours) {}

  @Schema(name = "Enrolment")
  record EnrolmentView(
      String id,
      @Nullable String agent,
      @Schema(description = "how many agents it still lets in") int usesLeft,
      Instant created,
      String createdBy,
      Instant expires) {
    static EnrolmentView of(Enrolment enrolment) {
      return new EnrolmentView(
          enrolment.id(),
          enrolment.agent().orElse(null),
          enrolment.usesLeft(),
          enrolment.created(),
          enrolment.createdBy(),
          enrolment.expires());
    }
  }

  @Schema(name = "EnrolmentWithSecret")
  record EnrolmentWithSecret(
      EnrolmentView enrolment,
      @Schema(
              description =
                  "the agent's SITAF_ENROLMENT_TOKEN at its first start; shown this once, stored"
                      + " nowhere")
          String secret) {}

  @GetMapping("/enrolments")
  @Operation(operationId = "listEnrolments", summary = "What lets agents in, the newest first")
  Listing<EnrolmentView> list(
      @RequestParam(defaultValue = "0") int page, @RequestParam(defaultValue = "50") int size) {
    PageRequest wanted = Listing.request(page, size, Sort.unsorted());
    return new Listing<>(
        enrolments.list(wanted).stream().map(EnrolmentView::of).toList(),
        page,
        size,
        enrolments.count());
  }

  @PostMapping("/enrolments")
  @Operation(operationId = "createEnrolment", summary = "Makes a token that lets agents in")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<EnrolmentWithSecret> create(@RequestBody EnrolmentRequest request) {
    if (request.uses() < 1 || request.uses() > MOST_USES) {
      throw Refusal.malformed("uses: 1 to " + MOST_USES + ".");
    }
    if (request.hours() < 1 || request.hours() > MOST_HOURS) {
      throw Refusal.malformed("hours: 1 to " + MOST_HOURS + ".");
    }
    Enrolments.WithSecret made =
        enrolments.create(
            request.agent(),
            request.uses(),
            Duration.ofHours(request.hours()),
            Caller.currentName());
    return ResponseEntity.created(URI.create("/api/v1/enrolments/" + made.enrolment().id()))
        .body(new EnrolmentWithSecret(EnrolmentView.of(made.enrolment()), made.secret()));
  }

  @DeleteMapping("/enrolments/{id}")
  @Operation(
      operationId = "deleteEnrolment",
      summary = "Lets no more agents in by this token",
      description = "Agents that are in stay in.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    enrolments.delete(id);
  }

  @DeleteMapping("/agents/{name}/key")
  @Operation(
      operationId = "revokeAgentKey",
      summary = "Shuts an agent out",
      description = "Its key is refused from now on; a new enrolment lets it in again.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void revoke(@PathVariable String name) {
    if (!enrolments.revoke(name)) {
      throw Refusal.notFound("agent with a key", name);
    }
  }
}
