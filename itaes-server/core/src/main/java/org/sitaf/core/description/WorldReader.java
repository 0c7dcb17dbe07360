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
 * Reads from a world description what a test needs to know of it. Bindings and the MJCF are the
 * simulator's to judge, since only it can compile them.
 */
public final class WorldReader {
  private WorldReader() {}

  /**
   * Reads a {@code *.world.yaml}.
   *
   * @param path where it lies among the files of the activity
   * @throws org.sitaf.core.diagnostic.InvalidInputException with every problem of the file
   */
  public static WorldDescription read(String text, String path) {
    Diagnostics diagnostics = new Diagnostics();
    YamlMapping root = YamlDocument.read(text, path, diagnostics);
    root.knowOnly(Set.of("mjcf", "robots", "parameters", "devices", "observations"));
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
                        name ->
                            all.mapping(name)
                                .ifPresent(
                                    d -> devices.add(new Device(name, d.requiredText("kind"))))));
    List<String> observations =
        root.mapping("observations").map(YamlMapping::names).orElse(List.of());
    diagnostics.throwIfErrors();
    return new WorldDescription(path, parameters, devices, observations);
  }

  private static WorldParameter parameter(String name, YamlMapping entry) {
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
