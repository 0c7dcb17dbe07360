package org.sitaf.server.schedule;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.build.Builds;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.Reservation;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.schedule.Schedule.Subject;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.suite.SuiteOrigin;
import org.sitaf.server.suite.Suites;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** Creates schedules and requests their builds. */
@Service
class Schedules {
  private final ScheduleRepository schedules;
  private final Calendars calendars;
  private final FireTimes fireTimes;
  private final BuildScheduler scheduler;
  private final Suites suites;
  private final Builds builds;
  private final TransactionTemplate transaction;
  private final DiskSpace disk;
  private final Clock clock;

  Schedules(
      ScheduleRepository schedules,
      Calendars calendars,
      FireTimes fireTimes,
      BuildScheduler scheduler,
      Suites suites,
      Builds builds,
      TransactionTemplate transaction,
      DiskSpace disk,
      Clock clock) {
    this.schedules = schedules;
    this.calendars = calendars;
    this.fireTimes = fireTimes;
    this.scheduler = scheduler;
    this.suites = suites;
    this.builds = builds;
    this.transaction = transaction;
    this.disk = disk;
    this.clock = clock;
  }

  /** The subject of a schedule that builds an existing suite. */
  Subject existingSuite(String suiteId) {
    SuiteOrigin origin = suites.origin(suiteId);
    return new Subject(origin.activityId(), origin.model(), suiteId, null);
  }

  /** The subject of a schedule that generates a new suite for each build. */
  Subject generatedSuites(String activityId, String model, @Nullable Long seed) {
    suites.requireModel(activityId, model);
    return new Subject(activityId, model, null, seed);
  }

  /**
   * Creates a schedule.
   *
   * @param misfire policy for times that are missed, such as while no server is running
   * @param leaveOut names of calendars whose days are excluded
   * @return its id
   */
  String create(
      String name,
      Subject subject,
      Timing timing,
      Misfire misfire,
      Set<String> leaveOut,
      BuildOptions options) {
    if (timing instanceof Timing.Reserved reserved && !reserved.at().toInstant().isAfter(now())) {
      throw RequestException.malformed(
          "at: " + reserved.at() + " is in the past; use a future time, or request a build.");
    }
    String id = UUID.randomUUID().toString();
    transaction.executeWithoutResult(
        status -> {
          schedules.save(
              new Schedule(id, name, subject, timing, misfire, leaveOut, options, now()));
          if (!scheduler.add(id, timing, misfire, calendars.union(leaveOut))) {
            throw RequestException.malformed(
                "The schedule would never fire; check its times and calendars.");
          }
        });
    scheduler.wake(id);
    return id;
  }

  /**
   * Requests the build of a fire time. Does nothing if it was requested before or the schedule was
   * deleted.
   */
  void fire(String id, Instant fireTime) {
    Schedule schedule = schedules.findById(id).orElse(null);
    if (schedule == null) {
      transaction.executeWithoutResult(status -> scheduler.remove(id));
      return;
    }
    Instant time = fireTime.truncatedTo(ChronoUnit.MICROS);
    if (!fireTimes.isRecorded(id, time)) {
      request(schedule, time);
    }
  }

  /** Records that a fire time has no build because each attempt to request one failed. */
  void giveUp(String id, Instant fireTime) {
    fireTimes.record(
        id,
        fireTime.truncatedTo(ChronoUnit.MICROS),
        now(),
        null,
        "The server failed to request the build; its log says why.");
  }

  /** Requests a build now, in addition to the schedule's fire times. */
  FireTimes.FireTime runNow(String id) {
    Instant now = now();
    request(find(id), now);
    return fireTimes.of(id, Pageable.ofSize(500)).stream()
        .filter(fire -> fire.fireTime().equals(now))
        .findFirst()
        .orElseThrow();
  }

  private void request(Schedule schedule, Instant time) {
    Subject subject = schedule.subject();
    @Nullable String buildId = null;
    String message = "";
    try {
      disk.requireForNewWork();
      String suiteId = subject.suiteId();
      if (suiteId == null) {
        suiteId = suites.generate(subject.activityId(), subject.model(), subject.seed());
      }
      buildId =
          builds.requestReserved(suiteId, schedule.options(), new Reservation(schedule.id(), time));
    } catch (InvalidInputException e) {
      message = "No suite can be generated from the model: " + e.diagnostics().get(0);
    } catch (RequestException | ComputationTimeoutException e) {
      message = String.valueOf(e.getMessage());
    }
    fireTimes.record(schedule.id(), time, now(), buildId, message);
    transaction.executeWithoutResult(
        status -> schedules.findById(schedule.id()).ifPresent(s -> s.markFired(now())));
  }

  void pause(String id) {
    change(id, true);
  }

  void resume(String id) {
    change(id, false);
    scheduler.wake(id);
  }

  private void change(String id, boolean pause) {
    transaction.executeWithoutResult(
        status -> {
          Schedule schedule = find(id);
          schedule.setPaused(pause);
          schedules.save(schedule);
          if (pause) {
            scheduler.pause(id);
          } else {
            scheduler.resume(id);
          }
        });
  }

  List<Instant> next(String id, int count) {
    return scheduler.next(find(id).id(), count);
  }

  /** The first fire times of a schedule that does not exist yet. */
  List<Instant> preview(Timing timing, Set<String> leaveOut, int count) {
    return BuildScheduler.preview(timing, calendars.union(leaveOut), count);
  }

  Page<FireTimes.FireTime> history(String id, Pageable page) {
    return fireTimes.of(find(id).id(), page);
  }

  /** Returns a page of the schedules; an activity of null means all. */
  Page<Schedule> list(@Nullable String activityId, Pageable page) {
    return activityId == null
        ? schedules.findAll(page)
        : schedules.findByActivityId(activityId, page);
  }

  Schedule find(String id) {
    return schedules.findById(id).orElseThrow(() -> RequestException.notFound("schedule", id));
  }

  void delete(String id) {
    transaction.executeWithoutResult(
        status -> {
          schedules.delete(find(id));
          scheduler.remove(id);
        });
  }

  /** Saves a calendar and updates the schedules that use it. */
  void saveCalendar(String name, org.sitaf.server.schedule.timing.ExcludedDays days) {
    transaction.executeWithoutResult(
        status -> {
          calendars.save(name, days);
          for (Schedule schedule : using(name)) {
            scheduler.exclude(
                schedule.id(), calendars.union(schedule.leaveOut()), schedule.timing().zone());
          }
        });
  }

  void deleteCalendar(String name) {
    transaction.executeWithoutResult(
        status -> {
          List<Schedule> users = using(name);
          if (!users.isEmpty()) {
            throw RequestException.conflict(
                users.size() + " schedules use calendar '" + name + "'; change them first.");
          }
          if (!calendars.delete(name)) {
            throw RequestException.notFound("calendar", name);
          }
        });
  }

  private List<Schedule> using(String calendar) {
    return schedules.findByLeaveOutContaining(calendar).stream()
        .filter(schedule -> schedule.leaveOut().contains(calendar))
        .toList();
  }

  private Instant now() {
    return Objects.requireNonNull(clock.instant()).truncatedTo(ChronoUnit.MICROS);
  }
}
