package org.sitaf.server.schedule;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;

/** A schedule in the REST interface. */
@Schema(name = "Schedule")
record ScheduleView(
    String id,
    @Nullable String name,
    String activityId,
    String model,
    @Schema(description = "suite to build; absent if a new suite is generated for each build")
        @Nullable String suiteId,
    @Nullable Long seed,
    @Schema(
            description =
                "time of the build, or of the first build of an interval, in the given zone")
        @Nullable OffsetDateTime at,
    @Nullable String cron,
    @Nullable Integer everyMinutes,
    String zone,
    @Schema(
            description =
                "policy for missed times: no build, one build for all of them, or one build for"
                    + " each")
        Misfire misfire,
    boolean paused,
    @Schema(description = "names of the calendars whose days are excluded") List<String> leaveOut,
    int priority,
    int shards,
    @Nullable Integer retries,
    @Nullable String toolchain,
    List<String> labels,
    @Nullable RecordedCases recordings,
    @Schema(description = "whether the failures of the builds are explained") boolean explain,
    @Schema(description = "what a ROS 2 node runs with, as in a build request")
        RosImplementation ros,
    Instant created,
    @Schema(description = "time of the last build; absent if there was none")
        @Nullable Instant fired,
    @Schema(description = "next fire time; absent if there is none") @Nullable Instant next) {

  /** A past fire time. */
  @Schema(name = "ScheduleFire")
  record FireView(
      Instant fireTime,
      Instant noted,
      @Nullable String buildId,
      @Schema(description = "absent if the build was deleted") @Nullable String buildState,
      @Schema(description = "why no build was requested") @Nullable String message) {
    static FireView of(FireTimes.FireTime fire) {
      return new FireView(
          fire.fireTime(),
          fire.noted(),
          fire.buildId(),
          fire.buildState(),
          fire.message().isEmpty() ? null : fire.message());
    }
  }

  static ScheduleView of(Schedule schedule, @Nullable Instant next) {
    Timing timing = schedule.timing();
    BuildOptions options = schedule.options();
    @Nullable OffsetDateTime at = null;
    if (timing instanceof Timing.Reserved reserved) {
      at = reserved.at();
    } else if (timing instanceof Timing.Interval interval) {
      at = interval.from().atZone(interval.zone()).toOffsetDateTime();
    }
    return new ScheduleView(
        schedule.id(),
        schedule.name().isEmpty() ? null : schedule.name(),
        schedule.subject().activityId(),
        schedule.subject().model(),
        schedule.subject().suiteId(),
        schedule.subject().seed(),
        at,
        timing instanceof Timing.Cron cron ? cron.expression() : null,
        timing instanceof Timing.Interval interval ? interval.minutes() : null,
        timing.zone().getId(),
        schedule.misfire(),
        schedule.paused(),
        schedule.leaveOut(),
        options.priority(),
        options.shards(),
        options.retries(),
        options.agent().toolchain().isEmpty() ? null : options.agent().toolchain(),
        List.copyOf(new TreeSet<>(options.agent().labels())),
        options.recordings(),
        options.explain(),
        options.ros(),
        schedule.created(),
        schedule.fired().orElse(null),
        next);
  }
}
