package org.sitaf.server.schedule;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.time.DayOfWeek;
import java.time.LocalDate;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.schedule.timing.ExcludedDays;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/calendars")
@Tag(name = "schedules")
class CalendarController {
  private final Calendars calendars;
  private final Schedules schedules;

  CalendarController(Calendars calendars, Schedules schedules) {
    this.calendars = calendars;
    this.schedules = schedules;
  }

  @Schema(name = "Calendar", description = "days on which the schedules that use it do not fire")
  record CalendarView(String name, Set<LocalDate> days, Set<DayOfWeek> weekdays) {
    static CalendarView of(String name, ExcludedDays days) {
      return new CalendarView(name, days.days(), days.weekdays());
    }
  }

  @Schema(name = "CalendarDays")
  record CalendarDays(
      @Schema(description = "dates, such as 2026-12-25") @Nullable Set<LocalDate> days,
      @Nullable Set<DayOfWeek> weekdays) {}

  @GetMapping
  @Operation(operationId = "listCalendars", summary = "Lists calendars by name")
  List<CalendarView> list() {
    return calendars.all().entrySet().stream()
        .map(e -> CalendarView.of(e.getKey(), e.getValue()))
        .toList();
  }

  @PutMapping("/{name}")
  @Operation(
      operationId = "saveCalendar",
      summary = "Creates or changes a calendar",
      description = "Schedules that use the calendar are updated.")
  CalendarView save(@PathVariable String name, @RequestBody CalendarDays request) {
    ExcludedDays days =
        new ExcludedDays(
            requireNoNulls("days", request.days()), requireNoNulls("weekdays", request.weekdays()));
    schedules.saveCalendar(name, days);
    return CalendarView.of(name, days);
  }

  @DeleteMapping("/{name}")
  @Operation(
      operationId = "deleteCalendar",
      summary = "Deletes a calendar",
      description = "Fails with 409 while a schedule uses it.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String name) {
    schedules.deleteCalendar(name);
  }

  /** Rejects null elements, which the JSON reader creates from empty strings. */
  private static <T> Set<T> requireNoNulls(String field, @Nullable Set<T> days) {
    if (days == null) {
      return Set.of();
    }
    for (T day : days) {
      if (day == null) {
        throw RequestException.malformed(field + ": must not contain empty entries.");
      }
    }
    return days;
  }
}
