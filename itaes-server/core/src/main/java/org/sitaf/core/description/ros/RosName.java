package org.sitaf.core.description.ros;

import java.util.Arrays;
import java.util.List;
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
    MSG("msg", ""),
    SRV("srv", "_Request", "_Response"),
    ACTION("action", "_Goal", "_Result", "_Feedback");

    private final String folder;
    private final List<String> sections;

    Kind(String folder, String... sections) {
      this.folder = folder;
      this.sections = List.of(sections);
    }

    String folder() {
      return folder;
    }

    int sections() {
      return sections.size();
    }

    static Optional<Kind> of(String path) {
      return Arrays.stream(values()).filter(k -> path.endsWith("." + k.folder)).findFirst();
    }
  }

  /** {@code geometry_msgs/Pose}, or only {@code Pose} if the package is unknown. */
  String qualified() {
    return packageName.isEmpty() ? name : packageName + "/" + name;
  }

  /**
   * The name of the message of a section, without the package, such as {@code Spin_Result}.
   *
   * @param index from 0; a section that the kind does not have is named as the file
   */
  String section(int index) {
    return index < kind.sections.size() ? name + kind.sections.get(index) : name;
  }

  /** The name of a derived type, such as {@code turtlesim/Spawn_Response}. */
  String qualified(String suffix) {
    return qualified() + "_" + suffix;
  }
}
