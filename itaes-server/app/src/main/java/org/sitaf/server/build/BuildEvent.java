package org.sitaf.server.build;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** Events of builds. Listeners receive them after the transaction was committed. */
public sealed interface BuildEvent {
  /**
   * A build was created or changed.
   *
   * @param parentId the build that the shard belongs to; null for a whole build
   */
  record Changed(String buildId, BuildState state, @Nullable String parentId)
      implements BuildEvent {
    static Changed of(Build build) {
      return new Changed(build.id(), build.state(), build.parentId().orElse(null));
    }
  }

  /** A build with shards has ended. */
  record ShardsEnded(String buildId, List<String> shardIds) implements BuildEvent {}

  /**
   * The server ended an attempt; its agent has to stop.
   *
   * @param abandoned whether the server lost the agent and stores a late result; false if a user
   *     cancelled the build
   */
  record Stopped(AttemptKey attempt, String agent, String reason, boolean abandoned)
      implements BuildEvent {}

  /** An agent delivered the outcome of an attempt. */
  record Delivered(AttemptKey attempt, String agent) implements BuildEvent {}

  /** Builds were deleted together with their activity. */
  record Deleted(List<String> buildIds) implements BuildEvent {}
}
