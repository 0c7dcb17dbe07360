package org.sitaf.agent.simulation;

import java.util.Optional;

/** The recorded motion of the case that runs, while it runs. Thread-safe. */
@FunctionalInterface
public interface LiveMotion {
  /**
   * The motion so far.
   *
   * @param glb binary glTF, as of a recording; made by the simulator of the build
   * @param version above 0; another one after each change
   */
  record Motion(byte[] glb, long version) {}

  /**
   * The motion so far if it has changed; the simulation goes on unchanged.
   *
   * @param known version of an earlier motion; 0 if there is none
   * @return empty if nothing changed, or no case records
   * @throws SimulatorException if the simulator does not answer
   */
  Optional<Motion> since(long known) throws SimulatorException;
}
