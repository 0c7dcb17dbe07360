package org.sitaf.server.schedule;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.schedule.ScheduleView.FireView;
import org.sitaf.server.web.Listing;
import org.sitaf.server.web.Sorting;
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
  private static final Sorting SORTING = Sorting.by("created", "name", "model");
  private static final String SORT =
      "one of created, name, model; a leading minus means descending order; default -created";

  private static final int MAX_TIMES = 100;

  private final Schedules schedules;
  private final BuildScheduler scheduler;
  private final Clock clock;

  ScheduleController(Schedules schedules, BuildScheduler scheduler, Clock clock) {
    this.schedules = schedules;
    this.scheduler = scheduler;
    this.clock = clock;
  }

  @PostMapping
  @Operation(
      operationId = "makeSchedule",
      summary = "Creates a schedule, which requests a build once or periodically")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<ScheduleView> create(@RequestBody ScheduleRequest request) {
    String id =
        schedules.create(
            request.nameOrNone(),
            request.subject(schedules),
            request.timing(clock.instant().atOffset(ZoneOffset.UTC)),
            request.misfireOrDefault(),
            request.leaveOutOrNone(),
            request.options());
    return ResponseEntity.created(URI.create("/api/v1/schedules/" + id)).body(get(id));
  }

  @GetMapping
  @Operation(operationId = "listSchedules", summary = "Lists schedules, newest first")
  Listing<ScheduleView> list(
      @RequestParam(required = false) @Nullable String activityId,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size,
      @Parameter(description = SORT) @RequestParam(required = false) @Nullable String sort) {
    return Listing.of(
        schedules.list(activityId, Listing.request(page, size, SORTING.order(sort))), this::view);
  }

  @GetMapping("/{id}")
  @Operation(operationId = "getSchedule", summary = "Returns a schedule")
  ScheduleView get(@PathVariable String id) {
    return view(schedules.find(id));
  }

  @DeleteMapping("/{id}")
  @Operation(operationId = "deleteSchedule", summary = "Deletes a schedule; its builds are kept")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    schedules.delete(id);
  }

  @PostMapping("/{id}/pause")
  @Operation(operationId = "pauseSchedule", summary = "Pauses a schedule until it is resumed")
  ScheduleView pause(@PathVariable String id) {
    schedules.pause(id);
    return get(id);
  }

  @PostMapping("/{id}/resume")
  @Operation(
      operationId = "resumeSchedule",
      summary = "Resumes a paused schedule",
      description = "The schedule's misfire policy applies to the times that it missed.")
  ScheduleView resume(@PathVariable String id) {
    schedules.resume(id);
    return get(id);
  }

  @PostMapping("/{id}/run")
  @Operation(operationId = "runSchedule", summary = "Requests a build of a schedule now")
  FireView run(@PathVariable String id) {
    return FireView.of(schedules.runNow(id));
  }

  @GetMapping("/{id}/fire-times")
  @Operation(operationId = "listFireTimes", summary = "Lists the next fire times of a schedule")
  List<Instant> fireTimes(@PathVariable String id, @RequestParam(defaultValue = "10") int count) {
    return schedules.next(id, requireCount(count));
  }

  @PostMapping("/preview")
  @Operation(
      operationId = "previewSchedule",
      summary = "Previews the fire times of a schedule",
      description =
          "Only times, zone and calendars are used. The list is empty if the schedule would never"
              + " fire.")
  List<Instant> preview(
      @RequestBody ScheduleRequest request, @RequestParam(defaultValue = "10") int count) {
    return schedules.preview(
        request.timing(clock.instant().atOffset(ZoneOffset.UTC)),
        request.leaveOutOrNone(),
        requireCount(count));
  }

  @GetMapping("/{id}/history")
  @Operation(
      operationId = "getScheduleHistory",
      summary = "Lists the past fire times of a schedule and their builds, newest first")
  Listing<FireView> history(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    return Listing.of(
        schedules.history(id, Listing.request(page, size, Sort.unsorted())), FireView::of);
  }

  private static int requireCount(int count) {
    if (count < 1 || count > MAX_TIMES) {
      throw RequestException.malformed("count: must be 1 to " + MAX_TIMES + ".");
    }
    return count;
  }

  private ScheduleView view(Schedule schedule) {
    return ScheduleView.of(
        schedule, schedule.paused() ? null : scheduler.next(schedule.id()).orElse(null));
  }
}
