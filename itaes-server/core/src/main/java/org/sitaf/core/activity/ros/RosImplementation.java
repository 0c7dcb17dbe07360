package org.sitaf.core.activity.ros;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What a ROS 2 node under test runs with. */
public enum RosImplementation {
  /** The API that comes along with the runtime, over simulated time; no ROS is needed. */
  INCLUDED,
  /** The ROS 2 that is installed on the agent, in real time. */
  SYSTEM;

  /** The name in options and documents. */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The implementation with a name. */
  public static Optional<RosImplementation> of(String id) {
    return Arrays.stream(values()).filter(i -> i.id().equals(id)).findFirst();
  }
}
