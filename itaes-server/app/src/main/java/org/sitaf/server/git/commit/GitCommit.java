package org.sitaf.server.git.commit;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A commit of a source.
 *
 * @param requestNo number of a pull or merge request; 0 for the branch
 * @param position in the branch; later commits have higher ones
 * @param ended when all its builds had ended
 * @param problem why it could not be built
 * @param baseId the commit that it is compared with; null for the first one
 * @param replaced whether a force-push has removed it from the branch
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
    boolean replaced) {
  private static final int SHORT = 10;

  /** How far a commit is. */
  public enum State {
    /** Will be built. */
    WAITING,
    /** Was pushed together with later ones, and is not built. */
    SKIPPED,
    /** Its builds are queued or running. */
    BUILDING,
    /** All its builds have ended. */
    DONE,
    /** Cannot be built; the problem says why. */
    INVALID
  }

  /** The beginning of the id. */
  public String shortSha() {
    return sha.substring(0, Math.min(SHORT, sha.length()));
  }
}
