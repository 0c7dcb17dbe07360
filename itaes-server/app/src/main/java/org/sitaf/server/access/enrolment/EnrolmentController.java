package org.sitaf.server.access.enrolment;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.error.RequestException;
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
  private static final int MAX_USES = 10_000;
  private static final int MAX_HOURS = 30 * 24;

  private final Enrolments enrolments;

  EnrolmentController(Enrolments enrolments) {
    this.enrolments = enrolments;
  }

  @Schema(name = "EnrolmentRequest")
  record EnrolmentRequest(
      @Schema(
              description =
                  "the only agent that may use it, also when an agent of that name has a key;"
                      + " absent for any agent without a key")
          @Nullable String agent,
      @Schema(description = "number of agents that can enrol with it, 1 to 10000") int uses,
      @Schema(description = "how long it is valid, 1 to 720 hours") int hours) {}

  @Schema(name = "Enrolment")
  record EnrolmentView(
      String id,
      @Nullable String agent,
      @Schema(description = "how many more agents can enrol with it") int usesLeft,
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
                  "the agent's SITAF_ENROLMENT_TOKEN at its first start; shown only once, not"
                      + " stored")
          String secret) {}

  @GetMapping("/enrolments")
  @Operation(operationId = "listEnrolments", summary = "Lists enrolment tokens, newest first")
  Listing<EnrolmentView> list(
      @RequestParam(defaultValue = "0") int page, @RequestParam(defaultValue = "50") int size) {
    PageRequest pageRequest = Listing.request(page, size, Sort.unsorted());
    return new Listing<>(
        enrolments.list(pageRequest).stream().map(EnrolmentView::of).toList(),
        page,
        size,
        enrolments.count());
  }

  @PostMapping("/enrolments")
  @Operation(operationId = "createEnrolment", summary = "Creates an enrolment token for agents")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<EnrolmentWithSecret> create(@RequestBody EnrolmentRequest request) {
    if (request.uses() < 1 || request.uses() > MAX_USES) {
      throw RequestException.malformed("uses: must be 1 to " + MAX_USES + ".");
    }
    if (request.hours() < 1 || request.hours() > MAX_HOURS) {
      throw RequestException.malformed("hours: must be 1 to " + MAX_HOURS + ".");
    }
    Enrolments.WithSecret created =
        enrolments.create(
            request.agent(),
            request.uses(),
            Duration.ofHours(request.hours()),
            Caller.currentName());
    return ResponseEntity.created(URI.create("/api/v1/enrolments/" + created.enrolment().id()))
        .body(new EnrolmentWithSecret(EnrolmentView.of(created.enrolment()), created.secret()));
  }

  @DeleteMapping("/enrolments/{id}")
  @Operation(
      operationId = "deleteEnrolment",
      summary = "Deletes an enrolment token",
      description = "Agents that enrolled with it keep their keys.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    enrolments.delete(id);
  }

  @DeleteMapping("/agents/{name}/key")
  @Operation(
      operationId = "revokeAgentKey",
      summary = "Revokes an agent's key",
      description = "The agent is disconnected until it enrols again.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void revoke(@PathVariable String name) {
    if (!enrolments.revoke(name)) {
      throw RequestException.notFound("agent with a key", name);
    }
  }
}
