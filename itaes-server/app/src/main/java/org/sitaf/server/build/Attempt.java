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
import org.sitaf.server.error.RequestException;

/**
 * An agent's attempt to execute a build. Its id is its fencing token; tokens increase, so that an
 * agent with an outdated attempt is recognized.
 *
 * <p>Updates write changed columns only, because other transactions renew the lease concurrently.
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
   * Creates an attempt.
   *
   * @param logStart offset of its log in the build's log, in bytes
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
   * Whether a batch of cases is new. Batch 0 is not numbered and always new.
   *
   * @throws RequestException if a batch is missing
   */
  boolean acceptBatch(long batch) {
    if (batch > nextBatch) {
      throw RequestException.malformed(
          "sequence: expected batch " + nextBatch + ", not " + batch + ".");
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

  void end(BuildState finalState, Instant now) {
    if (finished != null || !finalState.isOver()) {
      throw new IllegalStateException(
          "attempt " + token + " is " + state + " and cannot become " + finalState);
    }
    state = finalState;
    finished = now;
  }

  /** Ends the attempt with an accepted result. */
  void endWithResult(String sha256, Instant now) {
    end(BuildState.DONE, now);
    resultSha256 = sha256;
  }

  /** Marks an abandoned attempt that delivered a late result. */
  void supersede() {
    if (finished == null) {
      throw new IllegalStateException("attempt " + token + " has not ended");
    }
    state = BuildState.SUPERSEDED;
  }

  AttemptSummary summary() {
    return new AttemptSummary(no, agent, state, leased, finished);
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

  /** Whether the result with this hash was accepted from this attempt. */
  boolean delivered(String sha256) {
    return sha256.equals(resultSha256);
  }
}
