package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * The declarations of a world in its {@code *.world.yaml}: parameters that a test may vary, virtual
 * hardware, and observations.
 *
 * @param path path of the description in the activity
 */
public record WorldDescription(
    String path, List<WorldParameter> parameters, List<Device> devices, List<String> observations) {
  public WorldDescription {
    Objects.requireNonNull(path);
    parameters = List.copyOf(parameters);
    devices = List.copyOf(devices);
    observations = List.copyOf(observations);
  }

  /** Finds a parameter by name. */
  public Optional<WorldParameter> parameter(String name) {
    return parameters.stream().filter(p -> p.name().equals(name)).findFirst();
  }

  /**
   * A parameter that a test may vary (TDSD).
   *
   * @param unit SI unit; {@code 1} for a dimensionless number
   * @param min minimum, inclusive
   * @param max maximum, inclusive
   */
  public record WorldParameter(
      String name, String unit, double min, double max, double defaultValue) {
    public WorldParameter {
      Objects.requireNonNull(name);
      Objects.requireNonNull(unit);
    }

    /** Whether the world accepts a value. */
    public boolean contains(double value) {
      return value >= min && value <= max;
    }

    /** The declared range for messages. */
    public String range() {
      return "[" + min + ", " + max + "]";
    }
  }

  /**
   * A virtual hardware device.
   *
   * @param rateHz how often it sends messages to a ROS 2 node, greater than 0
   * @param rays number of rays of a laser scanner; 0 for other kinds
   */
  public record Device(String name, String kind, double rateHz, int rays) {
    /** The rate of a device that names none. */
    public static final double DEFAULT_RATE_HZ = 10;

    /** A device with the default rate. */
    public Device(String name, String kind) {
      this(name, kind, DEFAULT_RATE_HZ, 0);
    }

    public Device {
      Objects.requireNonNull(name);
      Objects.requireNonNull(kind);
    }
  }
}
