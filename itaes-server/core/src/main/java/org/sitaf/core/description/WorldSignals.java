package org.sitaf.core.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The names of the quantities that a simulator samples at each step: observations, {@code
 * DEVICE.FIELD} for a number of a reading, {@code DEVICE.FIELD.command} for a command to an
 * actuator. The fields of readings and commands are those of the simulator's device kinds.
 */
public final class WorldSignals {
  /** The kind of laser scanners. */
  static final String SCANNER = "laser_scan";

  /** The distances that a laser scanner measures. */
  private static final String RANGES = "ranges";

  /** {@code DEVICE.FIELD}, also with an index, or in {@code min()} or {@code max()}. */
  private static final Pattern FIELD =
      Pattern.compile("(?:(?:min|max)\\()?([^.()\\[\\]]+)\\.([^.()\\[\\]]+).*");

  private static final List<String> ORIENTATION =
      List.of("orientation.x", "orientation.y", "orientation.z", "orientation.w");

  /** Without cameras and laser scans, whose readings are not single numbers. */
  private static final Map<String, List<String>> READINGS =
      Map.ofEntries(
          Map.entry("range", List.of("range")),
          Map.entry("contact", List.of("pressed", "force")),
          Map.entry("joint_encoder", List.of("position", "velocity")),
          Map.entry("joint_motor", List.of("position", "velocity", "effort")),
          Map.entry(
              "differential_drive",
              List.of("linear", "angular", "left_position", "right_position")),
          Map.entry("gripper", List.of("width", "effort")),
          Map.entry("battery", List.of("voltage", "current", "charge", "percentage")),
          Map.entry("digital_io", List.of("level")),
          Map.entry("magnetometer", vector("field")),
          Map.entry("force_torque", join(vector("force"), vector("torque"))),
          Map.entry("pose", join(vector("position"), ORIENTATION)),
          Map.entry(
              "imu",
              join(ORIENTATION, join(vector("angular_velocity"), vector("linear_acceleration")))));

  private static final Map<String, List<String>> COMMANDS =
      Map.of(
          "joint_motor", List.of("position", "velocity", "effort"),
          "differential_drive", List.of("linear", "angular"),
          "gripper", List.of("width"),
          "digital_io", List.of("level"));

  /**
   * Units by kind and field; for a vector, the field without its component. Numbers without a unit
   * and joints, which turn or slide, are missing.
   */
  private static final Map<String, String> UNITS =
      Map.ofEntries(
          Map.entry("range.range", "m"),
          Map.entry("laser_scan.ranges", "m"),
          Map.entry("contact.force", "N"),
          Map.entry("differential_drive.linear", "m/s"),
          Map.entry("differential_drive.angular", "rad/s"),
          Map.entry("differential_drive.left_position", "rad"),
          Map.entry("differential_drive.right_position", "rad"),
          Map.entry("gripper.width", "m"),
          Map.entry("gripper.effort", "N"),
          Map.entry("battery.voltage", "V"),
          Map.entry("battery.current", "A"),
          Map.entry("battery.charge", "Ah"),
          Map.entry("magnetometer.field", "T"),
          Map.entry("force_torque.force", "N"),
          Map.entry("force_torque.torque", "N m"),
          Map.entry("pose.position", "m"),
          Map.entry("imu.angular_velocity", "rad/s"),
          Map.entry("imu.linear_acceleration", "m/s²"));

  private WorldSignals() {}

  /** The numbers in the readings of a kind of device; none of cameras and laser scans. */
  public static List<String> readings(String kind) {
    return READINGS.getOrDefault(kind, List.of());
  }

  /** The numbers in the commands that a kind of device takes; none of a sensor. */
  public static List<String> commands(String kind) {
    return COMMANDS.getOrDefault(kind, List.of());
  }

  /** The unit of a signal; empty if it has none or the world does not declare it. */
  public static String unit(WorldDescription world, String name) {
    Matcher field = FIELD.matcher(name);
    return world.devices().stream()
        .filter(device -> field.matches() && device.name().equals(field.group(1)))
        .map(device -> UNITS.getOrDefault(device.kind() + "." + field.group(2), ""))
        .findFirst()
        .orElse("");
  }

  /** All names; a name that is two signals is listed twice. */
  public static List<String> of(WorldDescription world) {
    List<String> names = new ArrayList<>(world.observations());
    for (WorldDescription.Device device : world.devices()) {
      readings(device.kind()).forEach(field -> names.add(device.name() + "." + field));
      commands(device.kind()).forEach(field -> names.add(device.name() + "." + field + ".command"));
    }
    return names;
  }

  /**
   * The readings that are lists of numbers, with their sizes: {@code DEVICE.ranges} of laser
   * scanners. A simulator samples their elements as {@code DEVICE.ranges[0]} and so on.
   */
  public static Map<String, Integer> lists(WorldDescription world) {
    Map<String, Integer> sizes = new TreeMap<>();
    for (WorldDescription.Device device : world.devices()) {
      if (device.kind().equals(SCANNER) && device.rays() > 0) {
        sizes.put(device.name() + "." + RANGES, device.rays());
      }
    }
    return sizes;
  }

  private static List<String> vector(String name) {
    return List.of(name + ".x", name + ".y", name + ".z");
  }

  private static List<String> join(List<String> first, List<String> second) {
    return Stream.concat(first.stream(), second.stream()).toList();
  }
}
