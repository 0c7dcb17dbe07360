package org.sitaf.server.schedule;

import jakarta.persistence.Entity;
import jakarta.persistence.Id;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** A reserved build: a suite, and when it is to be built. */
@Entity
class Schedule {
  @Id private String id;
  private String suiteId;
  private Instant fireAt;
  private String zone;
  private Instant created;
  private @Nullable Instant fired;

  /** For the persistence provider. */
  protected Schedule() {
    id = "";
    suiteId = "";
    fireAt = Instant.EPOCH;
    zone = "Z";
    created = Instant.EPOCH;
  }

  Schedule(String id, String suiteId, OffsetDateTime at, Instant now) {
    this();
    this.id = id;
    this.suiteId = suiteId;
    this.fireAt = at.toInstant();
    this.zone = at.getOffset().getId();
    this.created = now;
  }

  /** Its time has come, and the build is requested. */
  void markFired(Instant now) {
    if (fired == null) {
      fired = now;
    }
  }

  String id() {
    return id;
  }

  String suiteId() {
    return suiteId;
  }

  Instant fireAt() {
    return fireAt;
  }

  /** In the zone that its author gave. */
  OffsetDateTime at() {
    return fireAt.atZone(ZoneId.of(zone)).toOffsetDateTime();
  }

  Instant created() {
    return created;
  }

  Optional<Instant> fired() {
    return Optional.ofNullable(fired);
  }
}
