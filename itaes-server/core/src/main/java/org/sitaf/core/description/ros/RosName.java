package org.sitaf.core.description.ros;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/**
 * The name of a ROS 2 interface file.
 *
 * @param packageName empty if unknown
 * @param name name of the message, service or action
 */
record RosName(String packageName, Kind kind, String name) {
  RosName {
    Objects.requireNonNull(packageName);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(name);
  }

  /** The kind of a file. Folder and file extension have the same name. */
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

  /** {@code geometry_msgs/Pose}, or only {@code Pose} if the package is unknown. */
  String qualified() {
    return packageName.isEmpty() ? name : packageName + "/" + name;
  }

  /** The name of a derived type, such as {@code turtlesim/Spawn_Response}. */
  String qualified(String suffix) {
    return qualified() + "_" + suffix;
  }
}
