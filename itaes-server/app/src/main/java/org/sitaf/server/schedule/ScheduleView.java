package org.sitaf.server.schedule;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;

/** A schedule as people and programs see it. */
@Schema(name = "Schedule")
record ScheduleView(
    String id,
    @Nullable String name,
    String activityId,
    String model,
    @Schema(description = "suite that is built as it is; absent where one is made anew each time")
        @Nullable String suiteId,
    @Nullable Long seed,
    @Schema(description = "in the zone in which it was given; of a reservation or an interval")
        @Nullable OffsetDateTime at,
    @Nullable String cron,
    @Nullable Integer everyMinutes,
    String zone,
    @Schema(
            description =
                "what becomes of times that are missed: nothing, one build for all, or one build for each")
        Misfire misfire,
    boolean paused,
    @Schema(description = "names of calendars on whose days nothing fires") List<String> leaveOut,
    int priority,
    int shards,
    @Nullable Integer retries,
    @Nullable String toolchain,
    List<String> labels,
    @Nullable RecordedCases recordings,
    Instant created,
    @Schema(description = "when a build was last requested; absent before") @Nullable Instant fired,
    @Schema(description = "absent when it fires no more") @Nullable Instant next) {

  /** What came of a fire time. */
  @Schema(name = "ScheduleFire")
  record FireView(
      Instant fireTime,
      Instant noted,
      @Nullable String buildId,
      @Schema(description = "absent when there is no such build any more")
          @Nullable String buildState,
      @Schema(description = "why there is no build") @Nullable String message) {
    static FireView of(Fires.Fire fire) {
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
        options.parts(),
        options.retries(),
        options.agent().toolchain().isEmpty() ? null : options.agent().toolchain(),
        List.copyOf(new TreeSet<>(options.agent().labels())),
        options.recordings(),
        schedule.created(),
        schedule.fired().orElse(null),
        next);
  }
}
