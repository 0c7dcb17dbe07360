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
import org.sitaf.server.refusal.Refusal;
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
      "one of created, name, model; with a minus before it the largest first; without it -created";

  private static final int MAX_TIMES = 100;

  private final Schedules schedules;
  private final Clockwork clockwork;
  private final Clock clock;

  ScheduleController(Schedules schedules, Clockwork clockwork, Clock clock) {
    this.schedules = schedules;
    this.clockwork = clockwork;
    this.clock = clock;
  }

  @PostMapping
  @Operation(
      operationId = "makeSchedule",
      summary = "Schedules builds: once at a time to come, or periodically")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<ScheduleView> make(@RequestBody ScheduleRequest request) {
    String id =
        schedules.make(
            request.nameOrNone(),
            request.subject(schedules),
            request.timing(clock.instant().atOffset(ZoneOffset.UTC)),
            request.misfireOrDefault(),
            request.leaveOutOrNone(),
            request.options());
    return ResponseEntity.created(URI.create("/api/v1/schedules/" + id)).body(get(id));
  }

  @GetMapping
  @Operation(operationId = "listSchedules", summary = "Schedules, the newest first")
  Listing<ScheduleView> list(
      @RequestParam(required = false) @Nullable String activityId,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size,
      @Parameter(description = SORT) @RequestParam(required = false) @Nullable String sort) {
    return Listing.of(
        schedules.list(activityId, Listing.request(page, size, SORTING.order(sort))), this::view);
  }

  @GetMapping("/{id}")
  @Operation(operationId = "getSchedule", summary = "A schedule")
  ScheduleView get(@PathVariable String id) {
    return view(schedules.find(id));
  }

  @DeleteMapping("/{id}")
  @Operation(operationId = "deleteSchedule", summary = "Gives a schedule up; its builds stay")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    schedules.delete(id);
  }

  @PostMapping("/{id}/pause")
  @Operation(operationId = "pauseSchedule", summary = "Has a schedule not fire until it is resumed")
  ScheduleView pause(@PathVariable String id) {
    schedules.pause(id);
    return get(id);
  }

  @PostMapping("/{id}/resume")
  @Operation(
      operationId = "resumeSchedule",
      summary = "Has a paused schedule fire again",
      description = "What it missed meanwhile is dealt with as its misfire says.")
  ScheduleView resume(@PathVariable String id) {
    schedules.resume(id);
    return get(id);
  }

  @PostMapping("/{id}/run")
  @Operation(
      operationId = "runSchedule",
      summary = "Requests a build of a schedule now, beside its times")
  FireView run(@PathVariable String id) {
    return FireView.of(schedules.runNow(id));
  }

  @GetMapping("/{id}/fire-times")
  @Operation(operationId = "listFireTimes", summary = "The next times of a schedule")
  List<Instant> fireTimes(@PathVariable String id, @RequestParam(defaultValue = "10") int count) {
    return schedules.next(id, requireCount(count));
  }

  @PostMapping("/preview")
  @Operation(
      operationId = "previewSchedule",
      summary = "The next times that a schedule would have",
      description = "Looks at times, zone and days only; none where it would never fire.")
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
      summary = "What came of the times of a schedule, the latest first")
  Listing<FireView> history(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    return Listing.of(
        schedules.history(id, Listing.request(page, size, Sort.unsorted())), FireView::of);
  }

  private static int requireCount(int count) {
    if (count < 1 || count > MAX_TIMES) {
      throw Refusal.malformed("count: must be 1 to " + MAX_TIMES + ".");
    }
    return count;
  }

  private ScheduleView view(Schedule schedule) {
    return ScheduleView.of(
        schedule, schedule.paused() ? null : clockwork.next(schedule.id()).orElse(null));
  }
}
