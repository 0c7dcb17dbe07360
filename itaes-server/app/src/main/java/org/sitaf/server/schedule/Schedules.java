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
import org.sitaf.server.refusal.OvertimeException;
import org.sitaf.server.refusal.Refusal;
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

/** Schedules: what is to be built at which times, and what came of it. */
@Service
class Schedules {
  private final ScheduleRepository schedules;
  private final Calendars calendars;
  private final Fires fires;
  private final Clockwork clockwork;
  private final Suites suites;
  private final Builds builds;
  private final TransactionTemplate transaction;
  private final DiskSpace disk;
  private final Clock clock;

  Schedules(
      ScheduleRepository schedules,
      Calendars calendars,
      Fires fires,
      Clockwork clockwork,
      Suites suites,
      Builds builds,
      TransactionTemplate transaction,
      DiskSpace disk,
      Clock clock) {
    this.schedules = schedules;
    this.calendars = calendars;
    this.fires = fires;
    this.clockwork = clockwork;
    this.suites = suites;
    this.builds = builds;
    this.transaction = transaction;
    this.disk = disk;
    this.clock = clock;
  }

  /** What a suite that is built as it is belongs to. */
  Subject frozen(String suiteId) {
    SuiteOrigin origin = suites.origin(suiteId);
    return new Subject(origin.activityId(), origin.model(), suiteId, null);
  }

  /** A model of an activity, whose suite is made anew each time. */
  Subject anew(String activityId, String model, @Nullable Long seed) {
    suites.requireModel(activityId, model);
    return new Subject(activityId, model, null, seed);
  }

  /**
   * Makes a schedule; times that pass while no server is up are dealt with as {@code misfire} says.
   *
   * @param leaveOut names of calendars
   * @return its id
   */
  String make(
      String name,
      Subject subject,
      Timing timing,
      Misfire misfire,
      Set<String> leaveOut,
      BuildOptions options) {
    if (timing instanceof Timing.Reserved reserved && !reserved.at().toInstant().isAfter(now())) {
      throw Refusal.malformed(
          "at: " + reserved.at() + " is past; give a time to come, or request a build at once.");
    }
    String id = UUID.randomUUID().toString();
    transaction.executeWithoutResult(
        status -> {
          schedules.save(
              new Schedule(id, name, subject, timing, misfire, leaveOut, options, now()));
          if (!clockwork.arm(id, timing, misfire, calendars.union(leaveOut))) {
            throw Refusal.malformed("The schedule would never fire; look at its times and days.");
          }
        });
    clockwork.wake(id);
    return id;
  }

  /**
   * Requests the build of a fire time; doing so again makes no second one. A schedule that is gone
   * fires no more.
   */
  void fire(String id, Instant fireTime) {
    Schedule schedule = schedules.findById(id).orElse(null);
    if (schedule == null) {
      transaction.executeWithoutResult(status -> clockwork.disarm(id));
      return;
    }
    Instant time = fireTime.truncatedTo(ChronoUnit.MICROS);
    if (!fires.isNoted(id, time)) {
      request(schedule, time);
    }
  }

  /** Notes for people that a fire time has no build, since each attempt to request one failed. */
  void giveUp(String id, Instant fireTime) {
    fires.note(
        id,
        fireTime.truncatedTo(ChronoUnit.MICROS),
        now(),
        null,
        "The server failed to request the build; its log says why.");
  }

  /** Requests a build now, beside the times of the schedule. */
  Fires.Fire runNow(String id) {
    Instant now = now();
    request(find(id), now);
    return fires.of(id, Pageable.ofSize(500)).stream()
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
        suiteId = suites.generateAnew(subject.activityId(), subject.model(), subject.seed());
      }
      buildId =
          builds.requestReserved(suiteId, schedule.options(), new Reservation(schedule.id(), time));
    } catch (InvalidInputException e) {
      message = "The model gives no suite: " + e.diagnostics().get(0);
    } catch (Refusal | OvertimeException e) {
      message = String.valueOf(e.getMessage());
    }
    fires.note(schedule.id(), time, now(), buildId, message);
    transaction.executeWithoutResult(
        status -> schedules.findById(schedule.id()).ifPresent(s -> s.markFired(now())));
  }

  void pause(String id) {
    change(id, true);
  }

  void resume(String id) {
    change(id, false);
    clockwork.wake(id);
  }

  private void change(String id, boolean pause) {
    transaction.executeWithoutResult(
        status -> {
          Schedule schedule = find(id);
          schedule.pause(pause);
          schedules.save(schedule);
          if (pause) {
            clockwork.pause(id);
          } else {
            clockwork.resume(id);
          }
        });
  }

  List<Instant> next(String id, int count) {
    return clockwork.next(find(id).id(), count);
  }

  /** The next times of a schedule that is not made yet. */
  List<Instant> preview(Timing timing, Set<String> leaveOut, int count) {
    return Clockwork.times(timing, calendars.union(leaveOut), count);
  }

  Page<Fires.Fire> history(String id, Pageable page) {
    return fires.of(find(id).id(), page);
  }

  /** Of an activity, or of all where it is null. */
  Page<Schedule> list(@Nullable String activityId, Pageable page) {
    return activityId == null
        ? schedules.findAll(page)
        : schedules.findByActivityId(activityId, page);
  }

  Schedule find(String id) {
    return schedules.findById(id).orElseThrow(() -> Refusal.notFound("schedule", id));
  }

  void delete(String id) {
    transaction.executeWithoutResult(
        status -> {
          schedules.delete(find(id));
          clockwork.disarm(id);
        });
  }

  /** Puts a calendar in place, and has all schedules follow it that leave its days out. */
  void saveCalendar(String name, org.sitaf.server.schedule.timing.LeftOutDays days) {
    transaction.executeWithoutResult(
        status -> {
          calendars.save(name, days);
          for (Schedule schedule : using(name)) {
            clockwork.leaveOut(
                schedule.id(), calendars.union(schedule.leaveOut()), schedule.timing().zone());
          }
        });
  }

  void deleteCalendar(String name) {
    transaction.executeWithoutResult(
        status -> {
          List<Schedule> users = using(name);
          if (!users.isEmpty()) {
            throw Refusal.conflict(
                users.size() + " schedules leave the days of calendar '" + name + "' out.");
          }
          if (!calendars.delete(name)) {
            throw Refusal.notFound("calendar", name);
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
