package org.sitaf.server.git.commit;

/** Events of commits, published in the transaction that changes them. */
public sealed interface CommitEvent {
  String commitId();

  /** The builds of a commit were requested. */
  record Started(String commitId) implements CommitEvent {}

  /** A commit has its final state. */
  record Ended(String commitId) implements CommitEvent {}
}
