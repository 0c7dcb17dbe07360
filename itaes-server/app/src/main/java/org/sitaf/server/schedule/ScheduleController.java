package org.sitaf.server.schedule;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Instant;
import java.time.OffsetDateTime;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.web.Listing;
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
@RequestMapping("/api/v1/schedules")
@Tag(name = "schedules")
class ScheduleController {
  private final Schedules schedules;

  ScheduleController(Schedules schedules) {
    this.schedules = schedules;
  }

  @Schema(name = "ScheduleRequest")
  record ScheduleRequest(
      String suiteId,
      @Schema(description = "date and time with zone, such as 2026-12-01T22:00:00+09:00")
          OffsetDateTime at) {}

  @Schema(name = "Schedule")
  record ScheduleView(
      String id,
      String suiteId,
      @Schema(description = "in the zone in which it was given") OffsetDateTime at,
      Instant created,
      @Schema(description = "when the build was requested; absent before")
          @Nullable Instant fired) {
    static ScheduleView of(Schedule schedule) {
      return new ScheduleView(
          schedule.id(),
          schedule.suiteId(),
          schedule.at(),
          schedule.created(),
          schedule.fired().orElse(null));
    }
  }

  @PostMapping
  @Operation(operationId = "reserveBuild", summary = "Reserves a build at a time to come")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<ScheduleView> reserve(@RequestBody ScheduleRequest request) {
    if (request.suiteId() == null || request.at() == null) {
      throw Refusal.malformed("suiteId and at must be given.");
    }
    String id = schedules.reserve(request.suiteId(), request.at());
    return ResponseEntity.created(URI.create("/api/v1/schedules/" + id)).body(get(id));
  }

  @GetMapping
  @Operation(operationId = "listSchedules", summary = "Reserved builds, the latest time first")
  Listing<ScheduleView> list(
      @RequestParam(defaultValue = "0") int page, @RequestParam(defaultValue = "50") int size) {
    Sort latestFirst = Sort.by("fireAt").descending().and(Sort.by("id"));
    return Listing.of(schedules.list(Listing.request(page, size, latestFirst)), ScheduleView::of);
  }

  @GetMapping("/{id}")
  @Operation(operationId = "getSchedule", summary = "A reserved build")
  ScheduleView get(@PathVariable String id) {
    return ScheduleView.of(schedules.find(id));
  }

  @DeleteMapping("/{id}")
  @Operation(operationId = "deleteSchedule", summary = "Gives a reservation up")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    schedules.delete(id);
  }
}
