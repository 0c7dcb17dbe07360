package org.sitaf.core.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.YamlDocument;
import org.sitaf.core.document.YamlMapping;

/**
 * Reads the parts of a world description that a test needs. Bindings and the MJCF are checked by
 * the simulator, since only the simulator can compile them.
 */
public final class WorldReader {
  private static final double MAX_RATE_HZ = 100_000;

  /** The limit of the simulator. */
  private static final int MAX_RAYS = 4096;

  /** Those after {@code start} describe the robot if {@code mjcf} is a URDF. */
  private static final Set<String> KEYS =
      Set.of(
          "mjcf",
          "robots",
          "parameters",
          "devices",
          "observations",
          "start",
          "packages",
          "xacro_args",
          "base",
          "actuators",
          "pos",
          "rpy",
          "sites");

  private WorldReader() {}

  /**
   * Reads a {@code *.world.yaml}.
   *
   * @param path path of the file in the activity
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of the file
   */
  public static WorldDescription read(String text, String path) {
    Diagnostics diagnostics = new Diagnostics();
    YamlMapping root = YamlDocument.read(text, path, diagnostics);
    root.allowOnly(KEYS);
    root.requiredText("mjcf");
    List<WorldParameter> parameters = new ArrayList<>();
    root.mapping("parameters")
        .ifPresent(
            all ->
                all.names()
                    .forEach(
                        name ->
                            all.mapping(name).ifPresent(p -> parameters.add(parameter(name, p)))));
    List<Device> devices = new ArrayList<>();
    root.mapping("devices")
        .ifPresent(
            all ->
                all.names()
                    .forEach(
                        name -> all.mapping(name).ifPresent(d -> devices.add(device(name, d)))));
    List<String> observations =
        root.mapping("observations").map(YamlMapping::names).orElse(List.of());
    diagnostics.throwIfErrors();
    return new WorldDescription(path, parameters, devices, observations);
  }

  private static Device device(String name, YamlMapping entry) {
    double rate = entry.number("rate_hz").orElse(Device.DEFAULT_RATE_HZ);
    if (rate <= 0 || rate > MAX_RATE_HZ) {
      entry.problem("rate_hz", "must be greater than 0 and at most " + (int) MAX_RATE_HZ);
      rate = Device.DEFAULT_RATE_HZ;
    }
    String kind = entry.requiredText("kind");
    return new Device(name, kind, rate, kind.equals(WorldSignals.SCANNER) ? rays(entry) : 0);
  }

  private static int rays(YamlMapping entry) {
    double rays = entry.number("rays").orElse(0.0);
    if (entry.has("rays") && !(rays >= 2 && rays <= MAX_RAYS && rays == Math.rint(rays))) {
      entry.problem("rays", "must be a whole number from 2 to " + MAX_RAYS);
      return 0;
    }
    return (int) rays;
  }

  private static WorldParameter parameter(String name, YamlMapping entry) {
    entry.allowOnly(Set.of("unit", "range", "default", "bind"));
    double min = Double.NEGATIVE_INFINITY;
    double max = Double.POSITIVE_INFINITY;
    List<String> range = entry.texts("range");
    if (range.size() == 2) {
      try {
        min = Double.parseDouble(range.get(0));
        max = Double.parseDouble(range.get(1));
      } catch (NumberFormatException e) {
        entry.problem("range", "must be two numbers, such as [0, 10]");
      }
    } else if (entry.has("range")) {
      entry.problem("range", "must be two numbers, such as [0, 10]");
    }
    if (!(min <= max)) {
      entry.problem("range", "the lower end " + min + " is above the upper end " + max);
    }
    return new WorldParameter(
        name, entry.text("unit").orElse("1"), min, max, entry.number("default").orElse(0.0));
  }
}
