package org.sitaf.server.build.request;

import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.server.error.RequestException;

/**
 * Options of a build.
 *
 * @param priority -100 to 100; builds with higher priority run first
 * @param shards number of shards that run in parallel, 1 to 100
 * @param retries after infrastructure failures, 0 to 99; null for the server's default; failed
 *     tests are not retried
 * @param agent what the agent must provide
 * @param recordings which cases are recorded; null for {@link RecordedCases#byDefault}
 * @param cases the cases to execute, which keep their numbers; null for all
 * @param explain whether failures are explained when the build ends
 * @param ros what a ROS 2 node runs with
 */
public record BuildOptions(
    int priority,
    int shards,
    @Nullable Integer retries,
    AgentConstraints agent,
    @Nullable RecordedCases recordings,
    @Nullable CaseNumbers cases,
    boolean explain,
    RosImplementation ros) {
  public static final BuildOptions DEFAULT =
      new BuildOptions(
          0, 1, null, AgentConstraints.NONE, null, null, false, RosImplementation.INCLUDED);

  private static final int MAX_PRIORITY = 100;
  private static final int MAX_SHARDS = 100;
  private static final int MAX_RETRIES = 99;

  /** The size of the column. */
  private static final int MAX_CASES_TEXT = 100_000;

  public BuildOptions {
    if (Math.abs(priority) > MAX_PRIORITY) {
      throw RequestException.malformed("priority: must be -100 to 100.");
    }
    if (shards < 1 || shards > MAX_SHARDS) {
      throw RequestException.malformed("shards: must be 1 to 100.");
    }
    if (retries != null && (retries < 0 || retries > MAX_RETRIES)) {
      throw RequestException.malformed("retries: must be 0 to 99.");
    }
    if (cases != null && cases.merged().toString().length() > MAX_CASES_TEXT) {
      throw RequestException.malformed(
          "cases: must be at most " + MAX_CASES_TEXT + " characters; build the whole suite.");
    }
  }

  /** These options for other cases; null for all. */
  public BuildOptions withCases(@Nullable CaseNumbers numbers) {
    return new BuildOptions(priority, shards, retries, agent, recordings, numbers, explain, ros);
  }
}
