package org.sitaf.runtime;

import java.util.Set;

/**
 * The robot's hardware, as a component under test sees it. A component gets it by a constructor
 * argument of this type, or by {@link #current()}.
 *
 * <p>Only the test driver moves time: between two steps of the simulation every reading stays the
 * same, however often it is read, and reading costs no round trip to the simulator.
 */
public interface Hardware {

  /**
   * A sensor that measures one distance, such as an infrared or an ultrasonic sensor.
   *
   * @throws IllegalArgumentException when the robot has no range sensor of that name; the message
   *     lists those that it has
   */
  RangeSensor rangeSensor(String name);

  /** Names of all devices of the robot. */
  Set<String> devices();

  /**
   * The hardware of the running test, for components whose constructor cannot take it.
   *
   * @throws IllegalStateException when no test with a simulated world is running
   */
  static Hardware current() {
    return CurrentHardware.get();
  }
}
