package org.sitaf.server.git.request;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.git.source.Forge;

/**
 * A pull or merge request into the branch of a source.
 *
 * @param head id of its newest commit
 * @param fork whether its commits come from another repository; then its head is fetched and built
 *     only if somebody asked for exactly this commit
 * @param received when the forge first reported it
 * @param updated when the forge last reported it
 * @param askedHead the last head that somebody asked to build
 * @param askedBy who did
 * @param recordedHead the head whose commits were recorded
 * @param problem why the head cannot be built, and what to do
 */
record GitRequest(
    String sourceId,
    int number,
    Forge forge,
    String title,
    String author,
    String head,
    boolean fork,
    State state,
    Instant received,
    Instant updated,
    @Nullable String askedHead,
    @Nullable String askedBy,
    @Nullable Instant asked,
    @Nullable String recordedHead,
    @Nullable String problem) {

  /** Whether the request can be merged yet. */
  enum State {
    OPEN,
    /** Closed, merged, or moved to another branch. */
    CLOSED
  }

  boolean isOpen() {
    return state == State.OPEN;
  }

  /** Whether nothing of it is fetched before somebody asks for it. */
  boolean waitsForApproval() {
    return isOpen() && fork && !head.equals(askedHead);
  }

  /** Whether its commits that wait are those of its newest head. */
  boolean isRecorded() {
    return isOpen() && head.equals(recordedHead);
  }

  /** Where the forge offers the head. */
  String reference() {
    return (forge == Forge.GITLAB ? "refs/merge-requests/" : "refs/pull/") + number + "/head";
  }

  /** Where the server's copy keeps the head: no branch has such a name. */
  String localReference() {
    return "refs/requests/" + number;
  }
}
