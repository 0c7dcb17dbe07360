package org.sitaf.server.build.request;

import java.util.Objects;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.server.refusal.Refusal;

/**
 * What a person wants of the agent, besides what the files need anyway.
 *
 * @param toolchain release of the component's tools, such as {@code 17}; empty for any
 * @param labels that the agent must have
 */
public record AgentWishes(String toolchain, Set<String> labels) {
  /** None. */
  public static final AgentWishes NONE = new AgentWishes("", Set.of());

  private static final Pattern WORD = Pattern.compile("[A-Za-z0-9._-]{1,50}");
  private static final int MAX_LABELS = 20;

  public AgentWishes {
    if (labels.stream().anyMatch(Objects::isNull)) {
      throw Refusal.malformed("labels holds an empty entry; leave it out or name a label.");
    }
    labels = Set.copyOf(labels);
    if (!toolchain.isEmpty() && !WORD.matcher(toolchain).matches()) {
      throw Refusal.malformed("toolchain: must be a version such as 17 or 3.11.");
    }
    requireLabels(labels);
  }

  /**
   * Makes sure that each is a label.
   *
   * @throws Refusal when one is not
   */
  public static void requireLabels(Set<String> labels) {
    if (labels.size() > MAX_LABELS || labels.stream().anyMatch(l -> !WORD.matcher(l).matches())) {
      throw Refusal.malformed(
          "labels: at most " + MAX_LABELS + ", each 1 to 50 letters, digits, '.', '_' or '-'.");
    }
  }
}
