package org.sitaf.server.git.forge;

import org.jspecify.annotations.Nullable;

/**
 * The status of a commit as a forge shows it.
 *
 * @param context names who reports; the forge keeps the latest status of each
 * @param targetUrl the page of the commit
 */
record CommitStatus(
    String sha, Result result, String context, String description, String targetUrl) {
  /** What the status says. */
  enum Result {
    PENDING("pending", "pending"),
    SUCCESS("success", "success"),
    /** A case did not pass. */
    FAILURE("failure", "failed"),
    /** There is no result. */
    ERROR("error", "failed");

    private final String name;
    private final String gitLabName;

    Result(String name, String gitLabName) {
      this.name = name;
      this.gitLabName = gitLabName;
    }

    /** As GitHub and Gitea write it. */
    String text() {
      return name;
    }

    String gitLabText() {
      return gitLabName;
    }
  }

  /** Whether a forge shows this status already. */
  boolean isShown(@Nullable String shownResult, @Nullable String shownContext) {
    return context.equals(shownContext)
        && (result.name.equals(shownResult) || result.gitLabName.equals(shownResult));
  }
}
