package org.sitaf.server.git.commit;

import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.BuildState;

/**
 * The result of a model at a commit.
 *
 * @param takenFrom the commit whose build this is; null if this commit was built
 * @param total number of cases; null before the build has a result
 * @param compared number of cases that were compared with the base; null if they were not
 * @param differing number of those that differ
 */
public record GitCell(
    String commitId,
    String model,
    String buildId,
    @Nullable String takenFrom,
    BuildState state,
    boolean suspect,
    @Nullable Integer total,
    @Nullable Integer pass,
    @Nullable Integer fail,
    @Nullable Integer error,
    @Nullable String failure,
    @Nullable Integer compared,
    @Nullable Integer differing) {

  /** Whether all cases passed. */
  public boolean passed() {
    return state == BuildState.DONE && !suspect && total != null && total.equals(pass);
  }
}
