package org.sitaf.server.build.request;

import org.jspecify.annotations.Nullable;
import org.sitaf.server.refusal.Refusal;

/**
 * How a build is to be executed.
 *
 * @param priority -100 to 100; higher ones are given to agents first
 * @param parts over how many agents its cases are spread, 1 to 100
 * @param retries after failures of the infrastructure, 0 to 99; null as the server is set; a test
 *     that fails is never repeated
 * @param agent what the agent must be
 * @param recordings of which cases; null as {@link RecordedCases#byDefault} has it
 */
public record BuildOptions(
    int priority,
    int parts,
    @Nullable Integer retries,
    AgentWishes agent,
    @Nullable RecordedCases recordings) {
  /** As a build is executed when nobody says how. */
  public static final BuildOptions DEFAULT = new BuildOptions(0, 1, null, AgentWishes.NONE, null);

  private static final int MAX_PRIORITY = 100;
  private static final int MAX_PARTS = 100;
  private static final int MAX_RETRIES = 99;

  public BuildOptions {
    if (Math.abs(priority) > MAX_PRIORITY) {
      throw Refusal.malformed("priority: must be -100 to 100.");
    }
    if (parts < 1 || parts > MAX_PARTS) {
      throw Refusal.malformed("shards: must be 1 to 100.");
    }
    if (retries != null && (retries < 0 || retries > MAX_RETRIES)) {
      throw Refusal.malformed("retries: must be 0 to 99.");
    }
  }
}
