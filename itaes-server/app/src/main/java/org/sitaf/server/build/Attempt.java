package org.sitaf.server.build;

import jakarta.persistence.Column;
import jakarta.persistence.Entity;
import jakarta.persistence.EnumType;
import jakarta.persistence.Enumerated;
import jakarta.persistence.GeneratedValue;
import jakarta.persistence.GenerationType;
import jakarta.persistence.Id;
import jakarta.persistence.SequenceGenerator;
import java.time.Instant;
import org.hibernate.annotations.DynamicUpdate;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.refusal.Refusal;

/**
 * One try of an agent at a build. Its identity is its fencing token: tokens grow for ever, so that
 * whoever holds an older one is told apart from whoever holds the present one.
 *
 * <p>Only what has changed is written, because leases are renewed by other statements at the same
 * time.
 */
@Entity
@DynamicUpdate
class Attempt {
  @Id
  @GeneratedValue(strategy = GenerationType.SEQUENCE, generator = "fencing_token")
  @SequenceGenerator(name = "fencing_token", sequenceName = "fencing_token", allocationSize = 1)
  private long token;

  private String buildId;
  private int no;
  private String agent;

  @Enumerated(EnumType.STRING)
  private BuildState state;

  private Instant leased;

  private Instant leaseUntil;
  private @Nullable Instant finished;
  private long logStart;
  private long nextBatch;

  @Column(name = "result_sha256")
  private @Nullable String resultSha256;

  /** For the persistence provider. */
  protected Attempt() {
    buildId = "";
    agent = "";
    state = BuildState.LEASED;
    leased = Instant.EPOCH;
    leaseUntil = Instant.EPOCH;
  }

  /**
   * An attempt that begins now.
   *
   * @param logStart where its part of the build's log begins, in bytes
   */
  Attempt(String buildId, int no, String agent, Instant now, Instant leaseUntil, long logStart) {
    this();
    this.buildId = buildId;
    this.no = no;
    this.agent = agent;
    this.leased = now;
    this.leaseUntil = leaseUntil;
    this.logStart = logStart;
    this.nextBatch = 1;
  }

  void advance(BuildState to) {
    state = to;
  }

  /**
   * Whether a batch of cases is new; 0 does not count.
   *
   * @throws Refusal when one before it is missing
   */
  boolean takesBatch(long batch) {
    if (batch > nextBatch) {
      throw Refusal.malformed("sequence: batch " + nextBatch + " is expected, not " + batch + ".");
    }
    if (batch == nextBatch) {
      nextBatch++;
      return true;
    }
    return batch == 0;
  }

  long nextBatch() {
    return nextBatch;
  }

  void end(BuildState how, Instant now) {
    if (finished != null || !how.isOver()) {
      throw new IllegalStateException(
          "attempt " + token + " is " + state + " and cannot become " + how);
    }
    state = how;
    finished = now;
  }

  /** Its result is accepted. */
  void endWithResult(String sha256, Instant now) {
    end(BuildState.DONE, now);
    resultSha256 = sha256;
  }

  /** A result came after it was given up. */
  void supersede() {
    if (finished == null) {
      throw new IllegalStateException("attempt " + token + " is not given up");
    }
    state = BuildState.SUPERSEDED;
  }

  PastAttempt view() {
    return new PastAttempt(no, agent, state, leased, finished);
  }

  AttemptKey key() {
    return new AttemptKey(buildId, no, token);
  }

  boolean isOver() {
    return finished != null;
  }

  boolean isOverdue(Instant now) {
    return finished == null && leaseUntil.isBefore(now);
  }

  BuildState state() {
    return state;
  }

  String agent() {
    return agent;
  }

  long logStart() {
    return logStart;
  }

  /** Whether this very result was accepted from it. */
  boolean delivered(String sha256) {
    return sha256.equals(resultSha256);
  }
}
