package org.sitaf.cli.compare;

import org.sitaf.agent.simulation.SimulatorClient;
import org.sitaf.agent.simulation.SimulatorException;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The simulation bridge of NEW, which the user started.
 *
 * @param address gRPC target
 * @param version as it says itself
 */
record NewBridge(String address, String version) {
  private static final String OPTION = "--new-bridge ";

  /**
   * Asks the bridge for its version.
   *
   * @param activity that runs on it
   * @throws InvalidInputException if it cannot be used for the activity
   */
  static NewBridge at(String address, Activity activity) {
    if (activity.profile().world() == null) {
      throw InvalidInputException.of(
          OPTION + address, "has no effect, because NEW has no world; leave it out");
    }
    try (SimulatorClient client = new SimulatorClient(address)) {
      String version = client.version();
      if (!client.opensEndpoints()) {
        throw InvalidInputException.of(
            OPTION + address,
            "opens no endpoints for builds, so signals cannot be compared; start it with"
                + " --endpoints FOLDER");
      }
      return new NewBridge(address, version);
    } catch (SimulatorException | IllegalArgumentException e) {
      throw InvalidInputException.of(
          OPTION + address,
          e.getMessage()
              + "; start one with python -m sitaf_bridge serve --listen unix:/PATH --endpoints"
              + " FOLDER");
    }
  }
}
