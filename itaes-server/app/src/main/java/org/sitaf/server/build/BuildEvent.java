package org.sitaf.server.build;

import java.util.List;

/** What happens to builds; told after the transaction has ended well. */
public sealed interface BuildEvent {
  /** Anything of a build is different. */
  record Changed(String buildId, BuildState state) implements BuildEvent {}

  /** An attempt is over, and not by its agent: the agent is to stop the work on it. */
  record Stopped(AttemptKey attempt, String agent, String reason) implements BuildEvent {}

  /** An agent has brought an attempt to its end. */
  record Delivered(AttemptKey attempt, String agent) implements BuildEvent {}

  /** Builds are gone, together with their activity. */
  record Deleted(List<String> buildIds) implements BuildEvent {}
}
