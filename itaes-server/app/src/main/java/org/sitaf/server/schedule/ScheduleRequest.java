package org.sitaf.server.schedule;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.DateTimeException;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.server.build.request.AgentConstraints;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;

/**
 * A request to create a schedule, with either suiteId or activityId, and one of at, cron and
 * everyMinutes.
 */
@Schema(name = "ScheduleRequest")
record ScheduleRequest(
    @Schema(description = "at most 200 characters") @Nullable String name,
    @Schema(description = "suite to build") @Nullable String suiteId,
    @Schema(description = "activity of the model") @Nullable String activityId,
    @Schema(
            description =
                "model from which a new suite is generated for each build; with activityId")
        @Nullable String model,
    @Schema(description = "of the generated suites; with activityId") @Nullable Long seed,
    @Schema(
            description =
                "time of the build, such as 2026-12-01T22:00:00+09:00; with everyMinutes the time"
                    + " of the first build")
        @Nullable OffsetDateTime at,
    @Schema(
            description =
                "minute, hour, day of month, month and day of week, such as '0 3 * * 1-5'; Quartz's"
                    + " format is supported, too")
        @Nullable String cron,
    @Schema(description = "interval in minutes") @Nullable Integer everyMinutes,
    @Schema(description = "time zone of cron and calendars, such as Asia/Seoul; default UTC")
        @Nullable String zone,
    @Schema(description = "policy for missed times; default ONCE") @Nullable Misfire misfire,
    @Schema(description = "names of the calendars whose days are excluded")
        @Nullable Set<String> leaveOut,
    @Schema(description = "-100 to 100; builds with higher priority run first; default 0")
        @Nullable Integer priority,
    @Schema(description = "number of shards that run in parallel, 1 to 100; default 1")
        @Nullable Integer shards,
    @Schema(
            description =
                "number of retries after infrastructure failures, 0 to 99; failed tests are not"
                    + " retried")
        @Nullable Integer retries,
    @Schema(description = "version of the toolchain, such as 17; default any")
        @Nullable String toolchain,
    @Schema(description = "required labels of the agent") @Nullable Set<String> labels,
    @Schema(description = "which cases are recorded in the simulation, as in a build request")
        @Nullable RecordedCases recordings,
    @Schema(description = "whether the failures of the builds are explained; default false")
        @Nullable Boolean explain,
    @Schema(
            description =
                "what a ROS 2 node runs with: INCLUDED, the API that comes along, over simulated"
                    + " time, or SYSTEM, the ROS 2 that is installed on the agent, in real time;"
                    + " default INCLUDED")
        @Nullable RosImplementation ros) {
  private static final int MAX_NAME = 200;

  Schedule.Subject subject(Schedules schedules) {
    if ((suiteId == null) == (activityId == null)) {
      throw RequestException.malformed("Either suiteId or activityId must be given, not both.");
    }
    if (suiteId != null) {
      return schedules.existingSuite(suiteId);
    }
    if (activityId == null || model == null) {
      throw RequestException.malformed("model must be given with activityId.");
    }
    return schedules.generatedSuites(activityId, model, seed);
  }

  Timing timing(OffsetDateTime now) {
    long kinds = Stream.of(cron, everyMinutes).filter(java.util.Objects::nonNull).count();
    if (kinds > 1 || (kinds == 0 && at == null) || (cron != null && at != null)) {
      throw RequestException.malformed("One of at, cron and everyMinutes must be given.");
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
        new AgentConstraints(
            toolchain == null ? "" : toolchain, labels == null ? Set.of() : labels),
        recordings,
        null,
        Boolean.TRUE.equals(explain),
        ros == null ? RosImplementation.INCLUDED : ros);
  }

  Misfire misfireOrDefault() {
    return misfire == null ? Misfire.ONCE : misfire;
  }

  Set<String> leaveOutOrNone() {
    return leaveOut == null ? Set.of() : Set.copyOf(leaveOut);
  }

  String nameOrNone() {
    if (name != null && name.length() > MAX_NAME) {
      throw RequestException.malformed("name: must be at most " + MAX_NAME + " characters.");
    }
    return name == null ? "" : name.replace('\0', ' ');
  }

  private ZoneId zoneId() {
    try {
      return zone == null ? ZoneOffset.UTC : ZoneId.of(zone);
    } catch (DateTimeException e) {
      throw RequestException.malformed(
          "zone: '" + zone + "' is not a time zone; examples are Asia/Seoul and +09:00.");
    }
  }
}
