package org.sitaf.core.description.ros;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/**
 * What a file of ROS 2 is called there.
 *
 * @param packageName empty where nothing says so
 * @param name of the message, service or action
 */
record RosName(String packageName, Kind kind, String name) {
  RosName {
    Objects.requireNonNull(packageName);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(name);
  }

  /** Kinds of files; the folder of each is called as its ending. */
  enum Kind {
    MSG("msg", 1),
    SRV("srv", 2),
    ACTION("action", 3);

    private final String folder;
    private final int sections;

    Kind(String folder, int sections) {
      this.folder = folder;
      this.sections = sections;
    }

    String folder() {
      return folder;
    }

    int sections() {
      return sections;
    }

    static Optional<Kind> of(String path) {
      return Arrays.stream(values()).filter(k -> path.endsWith("." + k.folder)).findFirst();
    }
  }

  /** {@code geometry_msgs/Pose}; only {@code Pose} where the package is unknown. */
  String qualified() {
    return packageName.isEmpty() ? name : packageName + "/" + name;
  }

  /** A type that belongs to this one, such as {@code turtlesim/Spawn_Response}. */
  String qualified(String suffix) {
    return qualified() + "_" + suffix;
  }
}
