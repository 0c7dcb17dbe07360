package org.sitaf.core.activity;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.ComponentDescription;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostics;

/** The output data ports of the component under test, which a test can observe. */
final class OutputPorts {
  private OutputPorts() {}

  /**
   * Reads the output data ports of component profiles.
   *
   * @param provided documents of the provided interfaces, which may be profiles
   * @param profile profile of the component; null if there is none
   */
  static List<Port.Data> read(
      FileTree files, List<String> provided, @Nullable String profile, Diagnostics diagnostics) {
    List<String> asked = new ArrayList<>(provided.stream().filter(files::contains).toList());
    boolean more = profile != null && files.contains(profile) && !asked.contains(profile);
    if (more) {
      asked.add(profile);
    }
    ImportResult result =
        InterfaceFiles.read(
            SourceFiles.of("component", ActivityReader.interfaceFiles(files, asked), asked));
    if (more) {
      // Only warnings: the interfaces are defined by activity.yaml, so this profile is optional.
      result.diagnostics().stream()
          .filter(d -> d.file().equals(profile))
          .forEach(d -> diagnostics.warning(d.file(), d.line(), d.element(), d.message()));
    }
    return result.components().stream()
        .map(ComponentDescription::ports)
        .flatMap(List::stream)
        .filter(Port.Data.class::isInstance)
        .map(Port.Data.class::cast)
        .filter(Port.Data::output)
        .distinct()
        .toList();
  }

  /** The port of an observed output or of a part of it. */
  static Optional<Port.Data> named(List<Port.Data> ports, String output) {
    return ports.stream().filter(p -> p.name().equals(MemberPath.root(output))).findFirst();
  }
}
