package org.sitaf.server.audit;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/audit")
@Tag(name = "audit")
class AuditController {
  private final Audit audit;

  AuditController(Audit audit) {
    this.audit = audit;
  }

  @Schema(name = "AuditEvent")
  record EventView(
      long id,
      Instant at,
      @Schema(description = "a user, the owner of a token, an agent, or '-' if not authenticated")
          String actor,
      @Schema(description = "operationId of the request, or another name") String action,
      String subject,
      @Schema(description = "done, or why it was rejected") String outcome,
      @Schema(description = "of the client") String address) {
    static EventView of(Audit.Event event) {
      return new EventView(
          event.id(),
          event.at(),
          event.actor(),
          event.action(),
          event.subject(),
          event.outcome(),
          event.address());
    }
  }

  @GetMapping
  @Operation(operationId = "listAuditEvents", summary = "Lists audit events, newest first")
  Listing<EventView> list(
      @RequestParam(required = false) @Nullable String actor,
      @RequestParam(required = false) @Nullable String action,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    PageRequest pageRequest = Listing.request(page, size, Sort.unsorted());
    return new Listing<>(
        audit.list(actor, action, pageRequest).stream().map(EventView::of).toList(),
        page,
        size,
        audit.count(actor, action));
  }
}
