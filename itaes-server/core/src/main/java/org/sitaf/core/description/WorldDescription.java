package org.sitaf.core.description;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What a world declares in its {@code *.world.yaml}: what a test may vary, which hardware there is,
 * what can be observed.
 *
 * @param path where the description lies among the files of the activity
 */
public record WorldDescription(
    String path, List<WorldParameter> parameters, List<Device> devices, List<String> observations) {
  public WorldDescription {
    Objects.requireNonNull(path);
    parameters = List.copyOf(parameters);
    devices = List.copyOf(devices);
    observations = List.copyOf(observations);
  }

  /** The parameter of a name. */
  public Optional<WorldParameter> parameter(String name) {
    return parameters.stream().filter(p -> p.name().equals(name)).findFirst();
  }

  /**
   * Something that a test may vary (TDSD).
   *
   * @param unit SI unit, {@code 1} for a plain number
   * @param min smallest value that may be set, inclusive
   * @param max largest value that may be set, inclusive
   */
  public record WorldParameter(
      String name, String unit, double min, double max, double defaultValue) {
    public WorldParameter {
      Objects.requireNonNull(name);
      Objects.requireNonNull(unit);
    }
  }

  /** A piece of virtual hardware. */
  public record Device(String name, String kind) {
    public Device {
      Objects.requireNonNull(name);
      Objects.requireNonNull(kind);
    }
  }
}
