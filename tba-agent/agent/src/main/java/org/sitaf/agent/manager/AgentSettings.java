package org.sitaf.agent.manager;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.SandboxMode;

/**
 * All settings of an agent.
 *
 * @param server gRPC target of the server, such as {@code localhost:9090}
 * @param access how the agent gets in there
 * @param name unique among the agents of the server
 * @param version of the agent
 * @param directory private to this agent
 * @param slots builds that may run at the same time
 * @param bridgeCommand starts a simulation bridge of the agent's own; empty for none
 * @param bridge gRPC target of a running bridge; null for none
 * @param sandbox whether components and tools run in one
 * @param coverage whether builds say which lines of the component they reached
 * @param labels what its owner calls it by, such as {@code real-hardware}
 * @param minFreeBytes below which no new build is taken; what is there already is never dropped
 * @param longestBuild what the cases of a build may take together
 */
public record AgentSettings(
    String server,
    ServerAccess access,
    String name,
    String version,
    Path directory,
    int slots,
    List<String> bridgeCommand,
    @Nullable String bridge,
    SandboxMode sandbox,
    boolean coverage,
    Set<String> labels,
    long minFreeBytes,
    Duration longestBuild) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9._-]{1,100}");
  private static final Pattern LABEL = Pattern.compile("[A-Za-z0-9._-]{1,50}");
  private static final int MAX_LABELS = 20;
  private static final int MAX_SLOTS = 256;
  private static final Duration LONGEST = Duration.ofDays(30);

  public AgentSettings {
    Objects.requireNonNull(access);
    Objects.requireNonNull(version);
    Objects.requireNonNull(directory);
    Objects.requireNonNull(sandbox);
    bridgeCommand = List.copyOf(bridgeCommand);
    require(!server.isBlank(), "--server needs HOST:PORT");
    require(
        NAME.matcher(name).matches(),
        "--name '" + name + "': expected letters, digits, '.', '_', '-', at most 100");
    require(slots >= 1 && slots <= MAX_SLOTS, "--slots " + slots + ": expected 1 to " + MAX_SLOTS);
    require(
        bridgeCommand.isEmpty() || bridge == null,
        "--bridge-command and --bridge exclude each other");
    labels = Set.copyOf(labels);
    require(
        labels.size() <= MAX_LABELS && labels.stream().allMatch(l -> LABEL.matcher(l).matches()),
        "--label: at most 20, each 1 to 50 letters, digits, '.', '_', '-'");
    require(
        longestBuild.toMinutes() >= 1 && longestBuild.compareTo(LONGEST) <= 0,
        "--longest-build-min: expected 1 to " + LONGEST.toMinutes());
    require(minFreeBytes >= 0, "--min-free-mib must not be negative");
  }

  private static void require(boolean condition, String message) {
    if (!condition) {
      throw new IllegalArgumentException(message);
    }
  }
}
