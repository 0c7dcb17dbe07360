package org.sitaf.server.schedule;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.DateTimeException;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.request.AgentWishes;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;

/** A schedule to be made: one of suiteId and activityId, one of at, cron and everyMinutes. */
@Schema(name = "ScheduleRequest")
record ScheduleRequest(
    @Schema(description = "for people; at most 200 characters") @Nullable String name,
    @Schema(description = "suite that is built as it is") @Nullable String suiteId,
    @Schema(description = "activity of which a suite is made anew each time")
        @Nullable String activityId,
    @Schema(description = "model of the activity; with activityId") @Nullable String model,
    @Schema(description = "of the suites that are made anew; with activityId") @Nullable Long seed,
    @Schema(
            description =
                "date and time with zone, such as 2026-12-01T22:00:00+09:00; with everyMinutes the first time")
        @Nullable OffsetDateTime at,
    @Schema(
            description =
                "minute, hour, day of month, month, day of week; such as '0 3 * * 1-5'; Quartz's form is taken too")
        @Nullable String cron,
    @Schema(description = "minutes from one time to the next") @Nullable Integer everyMinutes,
    @Schema(description = "in which cron and days are meant, such as Asia/Seoul; UTC where absent")
        @Nullable String zone,
    @Schema(description = "what becomes of times that are missed; ONCE where absent")
        @Nullable Misfire misfire,
    @Schema(description = "names of calendars on whose days nothing fires")
        @Nullable Set<String> leaveOut,
    @Schema(description = "-100 to 100; higher ones are given to agents first; 0 where absent")
        @Nullable Integer priority,
    @Schema(description = "over how many agents the cases are spread, 1 to 100; 1 where absent")
        @Nullable Integer shards,
    @Schema(
            description =
                "after failures of the infrastructure, 0 to 99; a test that fails is never repeated")
        @Nullable Integer retries,
    @Schema(description = "release of the component's tools, such as 17; any where absent")
        @Nullable String toolchain,
    @Schema(description = "that the agent must have") @Nullable Set<String> labels,
    @Schema(description = "of which cases it is recorded what moves; as of a build")
        @Nullable RecordedCases recordings) {
  private static final int MAX_NAME = 200;

  /** What is built. */
  Schedule.Subject subject(Schedules schedules) {
    if ((suiteId == null) == (activityId == null)) {
      throw Refusal.malformed("Either suiteId or activityId must be given; not both.");
    }
    if (suiteId != null) {
      return schedules.frozen(suiteId);
    }
    if (activityId == null || model == null) {
      throw Refusal.malformed("model is missing; it says of which model suites are made.");
    }
    return schedules.anew(activityId, model, seed);
  }

  /** When it fires. */
  Timing timing(OffsetDateTime now) {
    long kinds = Stream.of(cron, everyMinutes).filter(java.util.Objects::nonNull).count();
    if (kinds > 1 || (kinds == 0 && at == null) || (cron != null && at != null)) {
      throw Refusal.malformed("One of at, cron and everyMinutes must be given.");
    }
    if (cron != null) {
      return new Timing.Cron(cron, zoneId());
    }
    if (everyMinutes != null) {
      return new Timing.Interval(everyMinutes, (at == null ? now : at).toInstant(), zoneId());
    }
    return new Timing.Reserved(at == null ? now : at);
  }

  BuildOptions options() {
    return new BuildOptions(
        priority == null ? 0 : priority,
        shards == null ? 1 : shards,
        retries,
        new AgentWishes(toolchain == null ? "" : toolchain, labels == null ? Set.of() : labels),
        recordings);
  }

  Misfire misfireOrDefault() {
    return misfire == null ? Misfire.ONCE : misfire;
  }

  Set<String> leaveOutOrNone() {
    return leaveOut == null ? Set.of() : Set.copyOf(leaveOut);
  }

  String nameOrNone() {
    if (name != null && name.length() > MAX_NAME) {
      throw Refusal.malformed("name: must be at most " + MAX_NAME + " characters.");
    }
    return name == null ? "" : name.replace('\0', ' ');
  }

  private ZoneId zoneId() {
    try {
      return zone == null ? ZoneOffset.UTC : ZoneId.of(zone);
    } catch (DateTimeException e) {
      throw Refusal.malformed(
          "zone: '" + zone + "' is no time zone; give one such as Asia/Seoul or +09:00.");
    }
  }
}
