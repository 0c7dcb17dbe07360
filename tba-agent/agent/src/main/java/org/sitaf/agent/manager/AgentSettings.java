package org.sitaf.agent.manager;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.core.activity.hardware.DeviceBackend;

/**
 * All settings of an agent.
 *
 * @param server gRPC target of the server, such as {@code localhost:9090}
 * @param access credentials and TLS settings
 * @param name unique among the agents of the server
 * @param version of the agent
 * @param directory private to this agent
 * @param slots maximum number of concurrent builds
 * @param bridgeCommand starts simulation bridges; empty for none
 * @param bridge gRPC target of a running bridge; null for none
 * @param sandbox whether components and tools run in a sandbox
 * @param coverage whether builds measure line coverage
 * @param labels labels that builds can require, such as {@code real-hardware}
 * @param devices addresses of the providers of real devices that builds may use, by device
 * @param minFreeBytes free disk space below which no build is accepted
 * @param longestBuild time limit for the cases of a build
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
    Map<String, String> devices,
    long minFreeBytes,
    Duration longestBuild) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9._-]{1,100}");
  private static final Pattern LABEL = Pattern.compile("[A-Za-z0-9._-]{1,50}");
  private static final int MAX_LABELS = 20;
  private static final int MAX_DEVICES = 100;
  private static final int MAX_SLOTS = 256;
  private static final Duration MAX_BUILD_TIME = Duration.ofDays(30);

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
    devices = Map.copyOf(devices);
    require(
        devices.isEmpty() || bridge == null,
        "--device needs a simulation for each build; use --bridge-command instead of --bridge");
    require(
        devices.size() <= MAX_DEVICES && devices.keySet().stream().allMatch(DeviceBackend::isName),
        "--device: at most "
            + MAX_DEVICES
            + ", each with the name of a device in a world, such as ir1=unix:/run/ir1.sock");
    devices.forEach(
        (device, address) ->
            require(
                DeviceBackend.isAddress(address),
                "--device "
                    + device
                    + "="
                    + address
                    + ": the address must be "
                    + DeviceBackend.ADDRESS_FORM));
    require(
        longestBuild.toMinutes() >= 1 && longestBuild.compareTo(MAX_BUILD_TIME) <= 0,
        "--longest-build-min: expected 1 to " + MAX_BUILD_TIME.toMinutes());
    require(minFreeBytes >= 0, "--min-free-mib must not be negative");
  }

  private static void require(boolean condition, String message) {
    if (!condition) {
      throw new IllegalArgumentException(message);
    }
  }
}
