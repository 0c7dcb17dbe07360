package org.sitaf.server.git.forge;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * What is reported of a commit, to others than a forge.
 *
 * @param activity name of the activity
 * @param request number of the pull or merge request; empty for the branch
 * @param result as a forge shows it: pending, success, failure or error
 * @param description one line
 * @param url the page of the commit
 * @param details empty before the commit has ended
 */
public record CommitReport(
    String activityId,
    String activity,
    String sha,
    String subject,
    String author,
    String branch,
    Optional<Integer> request,
    String result,
    String description,
    String url,
    Optional<Details> details) {

  /**
   * The results.
   *
   * @param comment Markdown with the groups of differences
   */
  public record Details(List<Model> models, String comment) {}

  /**
   * The result of a model.
   *
   * @param takenFrom the commit whose result it is; null if this commit was built
   * @param total number of cases; null without a result
   * @param compared number of cases that were compared with the base; null if they were not
   * @param differing number of those that differ
   */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  public record Model(
      String model,
      String build,
      String state,
      @Nullable String takenFrom,
      @Nullable Integer total,
      @Nullable Integer passed,
      @Nullable Integer compared,
      @Nullable Integer differing) {}
}
