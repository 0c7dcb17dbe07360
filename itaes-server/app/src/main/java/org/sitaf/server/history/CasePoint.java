package org.sitaf.server.history;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.CaseResult;

/**
 * A case in a commit or a build.
 *
 * @param commit id of the commit; null if the requester of the build did not say it
 * @param at when the commit was made, or the build was requested
 * @param replaced whether a force-push has removed the commit from the branch
 * @param buildId the build that has the result; null if there is none
 * @param takenFrom the commit whose result was taken over; null if there is none
 * @param reason why there is no result of the case; empty if there is one
 * @param result of the case; null if there is none
 */
record CasePoint(
    @Nullable Subject commit,
    Instant at,
    boolean replaced,
    @Nullable String buildId,
    @Nullable String takenFrom,
    boolean suspect,
    State state,
    String reason,
    @Nullable CaseResult result) {

  /** A commit; what is only known of commits from Git is empty otherwise. */
  record Subject(String sha, String subject, String author) {}

  /** Whether a commit or a build has a result of the case. */
  enum State {
    /** It has one. */
    JUDGED,
    /** It has a result without a case of these inputs, or does not have the test model. */
    ABSENT,
    /** Its build has ended without a result. */
    NO_RESULT,
    /** It waits, or is being built. */
    PENDING,
    /** It is not built: later commits were pushed before its turn. */
    NOT_BUILT,
    /** It cannot be built. */
    INVALID
  }
}
