package org.sitaf.server.build.request;

import java.util.Objects;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.server.error.RequestException;

/**
 * What a build request requires of the agent, in addition to what its files require.
 *
 * @param toolchain version of the toolchain, such as {@code 17}; empty for any
 * @param labels that the agent must have
 */
public record AgentConstraints(String toolchain, Set<String> labels) {
  public static final AgentConstraints NONE = new AgentConstraints("", Set.of());

  private static final Pattern WORD = Pattern.compile("[A-Za-z0-9._-]{1,50}");
  private static final int MAX_LABELS = 20;

  public AgentConstraints {
    if (labels.stream().anyMatch(Objects::isNull)) {
      throw RequestException.malformed("labels: must not contain empty entries.");
    }
    labels = Set.copyOf(labels);
    if (!toolchain.isEmpty() && !WORD.matcher(toolchain).matches()) {
      throw RequestException.malformed("toolchain: must be a version such as 17 or 3.11.");
    }
    requireLabels(labels);
  }

  /**
   * Validates labels.
   *
   * @throws RequestException if a label is invalid
   */
  public static void requireLabels(Set<String> labels) {
    if (labels.size() > MAX_LABELS || labels.stream().anyMatch(l -> !WORD.matcher(l).matches())) {
      throw RequestException.malformed(
          "labels: must be at most "
              + MAX_LABELS
              + ", each 1 to 50 letters, digits, '.', '_' or '-'.");
    }
  }
}
