package org.sitaf.server.schedule;

import jakarta.persistence.Column;
import jakarta.persistence.Entity;
import jakarta.persistence.EnumType;
import jakarta.persistence.Enumerated;
import jakarta.persistence.Id;
import java.time.Instant;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.server.build.request.AgentConstraints;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;

/** A schedule: what to build, how and when. */
@Entity
class Schedule {
  private static final String SEPARATOR = ",";

  @Id private String id;
  private String name;

  @Column(name = "activity_id")
  private String activityId;

  private String model;
  private @Nullable String suiteId;
  private @Nullable Long seed;

  /** The time of a reservation, or the start of an interval. */
  private @Nullable Instant fireAt;

  private String zone;
  private @Nullable String cron;
  private @Nullable Integer everyMinutes;

  @Enumerated(EnumType.STRING)
  private Misfire misfire;

  private boolean paused;
  private String leaveOut;
  private int priority;
  private int shards;
  private @Nullable Integer retries;
  private String toolchain;
  private String labels;

  @Enumerated(EnumType.STRING)
  private @Nullable RecordedCases recordedCases;

  private boolean explainFailures;

  @Enumerated(EnumType.STRING)
  private RosImplementation ros;

  private Instant created;
  private @Nullable Instant fired;

  /** For the persistence provider. */
  protected Schedule() {
    id = "";
    name = "";
    activityId = "";
    model = "";
    zone = "Z";
    misfire = Misfire.ONCE;
    leaveOut = "";
    toolchain = "";
    labels = "";
    ros = RosImplementation.INCLUDED;
    created = Instant.EPOCH;
  }

  /**
   * What to build.
   *
   * @param suiteId an existing suite; null to generate a new suite from the model for each build
   * @param seed of the generated suites; null for the default
   */
  record Subject(String activityId, String model, @Nullable String suiteId, @Nullable Long seed) {}

  /**
   * Creates a schedule.
   *
   * @param leaveOut names of calendars whose days are excluded
   */
  Schedule(
      String id,
      String name,
      Subject subject,
      Timing timing,
      Misfire misfire,
      Set<String> leaveOut,
      BuildOptions options,
      Instant now) {
    this();
    this.id = id;
    this.name = name;
    this.activityId = subject.activityId();
    this.model = subject.model();
    this.suiteId = subject.suiteId();
    this.seed = subject.seed();
    this.zone = timing.zone().getId();
    if (timing instanceof Timing.Reserved reserved) {
      this.fireAt = reserved.at().toInstant();
    } else if (timing instanceof Timing.Cron periodic) {
      this.cron = periodic.expression();
    } else if (timing instanceof Timing.Interval interval) {
      this.everyMinutes = interval.minutes();
      this.fireAt = interval.from();
    }
    this.misfire = misfire;
    this.leaveOut = String.join(SEPARATOR, new TreeSet<>(leaveOut));
    this.priority = options.priority();
    this.shards = options.shards();
    this.retries = options.retries();
    this.toolchain = options.agent().toolchain();
    this.labels = String.join(SEPARATOR, new TreeSet<>(options.agent().labels()));
    this.recordedCases = options.recordings();
    this.explainFailures = options.explain();
    this.ros = options.ros();
    this.created = now;
  }

  /** Stores the time when a build was last requested. */
  void markFired(Instant now) {
    fired = now;
  }

  void setPaused(boolean paused) {
    this.paused = paused;
  }

  String id() {
    return id;
  }

  String name() {
    return name;
  }

  Subject subject() {
    return new Subject(activityId, model, suiteId, seed);
  }

  Timing timing() {
    if (cron != null) {
      return new Timing.Cron(cron, ZoneId.of(zone));
    }
    Instant at = Optional.ofNullable(fireAt).orElse(created);
    return everyMinutes == null
        ? new Timing.Reserved(at.atZone(ZoneId.of(zone)).toOffsetDateTime())
        : new Timing.Interval(everyMinutes, at, ZoneId.of(zone));
  }

  Misfire misfire() {
    return misfire;
  }

  boolean paused() {
    return paused;
  }

  /** Names of the calendars whose days are excluded. */
  List<String> leaveOut() {
    return leaveOut.isEmpty() ? List.of() : List.of(leaveOut.split(SEPARATOR));
  }

  BuildOptions options() {
    return new BuildOptions(
        priority,
        shards,
        retries,
        new AgentConstraints(
            toolchain, labels.isEmpty() ? Set.of() : Set.of(labels.split(SEPARATOR))),
        recordedCases,
        null,
        explainFailures,
        ros);
  }

  Instant created() {
    return created;
  }

  Optional<Instant> fired() {
    return Optional.ofNullable(fired);
  }
}
