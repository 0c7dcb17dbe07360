package org.sitaf.server.build;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** What happens to builds; told after the transaction has ended well. */
public sealed interface BuildEvent {
  /**
   * Anything of a build is different.
   *
   * @param parentId the build that it is a part of; null for a whole build
   */
  record Changed(String buildId, BuildState state, @Nullable String parentId)
      implements BuildEvent {
    static Changed of(Build build) {
      return new Changed(build.id(), build.state(), build.parentId().orElse(null));
    }
  }

  /** A build that was spread over parts is over. */
  record PartsEnded(String buildId, List<String> partIds) implements BuildEvent {}

  /**
   * An attempt is over, and not by its agent: the agent is to stop the work on it.
   *
   * @param givenUp by this server, which keeps a late result; false where somebody cancelled it
   */
  record Stopped(AttemptKey attempt, String agent, String reason, boolean givenUp)
      implements BuildEvent {}

  /** An agent has brought an attempt to its end. */
  record Delivered(AttemptKey attempt, String agent) implements BuildEvent {}

  /** Builds are gone, together with their activity. */
  record Deleted(List<String> buildIds) implements BuildEvent {}
}
