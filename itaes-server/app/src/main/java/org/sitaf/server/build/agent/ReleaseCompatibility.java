package org.sitaf.server.build.agent;

import io.grpc.Status;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Agents and servers are compatible if they are at most one minor release apart. */
final class ReleaseCompatibility {
  private static final Pattern RELEASE = Pattern.compile("(\\d{1,6})\\.(\\d{1,6})(\\..*)?");

  private ReleaseCompatibility() {}

  /**
   * Checks that agent and server are compatible; development versions are not checked.
   *
   * @throws io.grpc.StatusRuntimeException FAILED_PRECONDITION if they are not
   */
  static void requireCompatible(String agent, String server) {
    Matcher ofAgent = RELEASE.matcher(agent);
    Matcher ofServer = RELEASE.matcher(server);
    if (!ofAgent.matches() || !ofServer.matches()) {
      return;
    }
    int majors = Integer.parseInt(ofAgent.group(1)) - Integer.parseInt(ofServer.group(1));
    int minors = Integer.parseInt(ofAgent.group(2)) - Integer.parseInt(ofServer.group(2));
    if (majors != 0 || Math.abs(minors) > 1) {
      boolean agentIsOlder = majors < 0 || (majors == 0 && minors < 0);
      throw Status.FAILED_PRECONDITION
          .withDescription(
              "the agent is release "
                  + agent
                  + ", the server "
                  + server
                  + ": they must be at most one release apart; update the "
                  + (agentIsOlder ? "agent" : "server"))
          .asRuntimeException();
    }
  }
}
