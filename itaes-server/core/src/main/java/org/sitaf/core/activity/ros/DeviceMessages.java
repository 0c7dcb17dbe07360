package org.sitaf.core.activity.ros;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The messages that each kind of device can send and take. */
final class DeviceMessages {
  private static final Map<String, List<String>> SENT =
      Map.of(
          "laser_scan", List.of("sensor_msgs/LaserScan"),
          "pose",
              List.of(
                  "nav_msgs/Odometry",
                  "geometry_msgs/PoseStamped",
                  "geometry_msgs/PoseWithCovarianceStamped"),
          "differential_drive", List.of("nav_msgs/Odometry", "sensor_msgs/JointState"),
          "imu", List.of("sensor_msgs/Imu"),
          "joint_encoder", List.of("sensor_msgs/JointState"),
          "camera", List.of("sensor_msgs/Image"),
          "range", List.of("sensor_msgs/Range"),
          "battery", List.of("sensor_msgs/BatteryState"));

  private static final Map<String, List<String>> TAKEN =
      Map.of("differential_drive", List.of("geometry_msgs/Twist", "geometry_msgs/TwistStamped"));

  private DeviceMessages() {}

  /** All messages that fit a kind of device. */
  static List<String> of(String kind) {
    return Stream.concat(sent(kind).stream(), taken(kind).stream()).toList();
  }

  static List<String> sent(String kind) {
    return SENT.getOrDefault(kind, List.of());
  }

  static List<String> taken(String kind) {
    return TAKEN.getOrDefault(kind, List.of());
  }
}
