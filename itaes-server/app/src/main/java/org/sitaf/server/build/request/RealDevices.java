package org.sitaf.server.build.request;

import java.util.Set;
import java.util.TreeSet;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Role;
import org.sitaf.server.error.RequestException;

/**
 * The rules for builds that use real devices. Such a build moves machines, so a person with the
 * role {@link Role#OPERATOR} must ask for it, and its cases run one after the other on one agent.
 */
public final class RealDevices {
  private RealDevices() {}

  /**
   * Verifies that the caller may request a build. Nobody is the caller of a schedule's fire time or
   * of a fetched commit.
   *
   * @throws RequestException if the build uses real devices and may not
   */
  public static void requireAllowed(Requirements requirements, BuildOptions options) {
    Set<String> devices = requirements.devices();
    if (devices.isEmpty()) {
      return;
    }
    String uses = "the activity uses real devices (" + String.join(", ", new TreeSet<>(devices));
    if (options.shards() > 1) {
      throw RequestException.malformed("shards: must be 1, because " + uses + ").");
    }
    if (options.explain()) {
      throw RequestException.malformed(
          "explain: must be false, because " + uses + "), and an analysis needs simulated ones.");
    }
    if (!Caller.isKnown() || !Caller.current().role().includes(Role.OPERATOR)) {
      throw RequestException.forbidden(
          "This build must be requested by a user with the role OPERATOR, or with such a user's"
              + " token, because "
              + uses
              + ").");
    }
  }

  /**
   * Verifies that a build can be analysed, which executes further cases.
   *
   * @throws RequestException if it uses real devices
   */
  public static void requireNone(Requirements requirements) {
    if (!requirements.devices().isEmpty()) {
      throw RequestException.conflict(
          "Builds with real devices are not analysed; simulate "
              + String.join(", ", new TreeSet<>(requirements.devices()))
              + " in activity.yaml, and build again.");
    }
  }
}
