package org.sitaf.server.git.commit;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A commit of a source.
 *
 * @param requestNo number of a pull or merge request; 0 for the branch; negative for a commit of
 *     the branch that is built only for the search with the opposite number
 * @param position in the branch or the request; later commits have higher ones
 * @param ended when all its builds had ended
 * @param problem why it could not be built
 * @param baseId the commit that it is compared with; null for the first one
 * @param replaced whether a force-push has removed it from the branch
 * @param mergeBase whether it is a commit of the branch that is built only to compare the heads of
 *     a request with it
 */
public record GitCommit(
    String id,
    String sourceId,
    String sha,
    int requestNo,
    long position,
    String subject,
    String author,
    Instant authored,
    Instant received,
    @Nullable Instant ended,
    State state,
    @Nullable String problem,
    @Nullable String baseId,
    boolean replaced,
    boolean mergeBase) {
  private static final int SHORT = 10;

  /** How far a commit is. */
  public enum State {
    /** Will be built. */
    WAITING,
    /** Is not built: later ones were pushed before its turn, or its request was closed. */
    SKIPPED,
    /** Its builds are queued or running. */
    BUILDING,
    /** All its builds have ended. */
    DONE,
    /** Cannot be built; the problem says why. */
    INVALID
  }

  /** Whether it is built only to find the first bad commit. */
  public boolean isOfBisection() {
    return requestNo < 0;
  }

  /** Whether its status is reported; what is built for another commit is not. */
  public boolean isReported() {
    return !mergeBase && !isOfBisection();
  }

  /** The beginning of the id. */
  public String shortSha() {
    return sha.substring(0, Math.min(SHORT, sha.length()));
  }
}
