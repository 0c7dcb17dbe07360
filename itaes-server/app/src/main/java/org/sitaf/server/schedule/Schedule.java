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
import org.sitaf.server.build.request.AgentWishes;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;

/** What is to be built, how, and when. */
@Entity
class Schedule {
  private static final String SEPARATOR = ",";

  @Id private String id;
  private String name;

  @Column(name = "workspace_id")
  private String activityId;

  private String model;
  private @Nullable String suiteId;
  private @Nullable Long seed;

  /** The time of a reservation, or the first time of an interval. */
  private @Nullable Instant fireAt;

  private String zone;
  private @Nullable String cron;
  private @Nullable Integer everyMinutes;

  @Enumerated(EnumType.STRING)
  private Misfire misfire;

  private boolean paused;
  private String leaveOut;
  private int priority;
  private int parts;
  private @Nullable Integer retries;
  private String toolchain;
  private String labels;

  @Enumerated(EnumType.STRING)
  private @Nullable RecordedCases recordedCases;

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
    created = Instant.EPOCH;
  }

  /**
   * What is built.
   *
   * @param suiteId a suite as it is; null to make one anew from the model each time
   * @param seed of the suites that are made anew; null as the model is generated without one
   */
  record Subject(String activityId, String model, @Nullable String suiteId, @Nullable Long seed) {}

  /**
   * A schedule.
   *
   * @param leaveOut names of calendars
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
    this.parts = options.parts();
    this.retries = options.retries();
    this.toolchain = options.agent().toolchain();
    this.labels = String.join(SEPARATOR, new TreeSet<>(options.agent().labels()));
    this.recordedCases = options.recordings();
    this.created = now;
  }

  /** A build was requested. */
  void markFired(Instant now) {
    fired = now;
  }

  void pause(boolean whether) {
    paused = whether;
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

  /** Names of calendars. */
  List<String> leaveOut() {
    return leaveOut.isEmpty() ? List.of() : List.of(leaveOut.split(SEPARATOR));
  }

  BuildOptions options() {
    return new BuildOptions(
        priority,
        parts,
        retries,
        new AgentWishes(toolchain, labels.isEmpty() ? Set.of() : Set.of(labels.split(SEPARATOR))),
        recordedCases);
  }

  Instant created() {
    return created;
  }

  Optional<Instant> fired() {
    return Optional.ofNullable(fired);
  }
}
