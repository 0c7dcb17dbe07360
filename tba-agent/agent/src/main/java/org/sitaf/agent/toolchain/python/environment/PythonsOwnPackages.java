package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The packages that Python adds to each new environment, such as pip.
 *
 * @param site the folder of packages in an environment with nothing else
 */
record PythonsOwnPackages(Path site) {
  private static final String INFO = ".dist-info";

  /**
   * Links them into another environment's folder of packages.
   *
   * @param others normalized names of those that have another release there
   */
  void link(Path packages, Set<String> others) throws IOException {
    List<Path> infos;
    try (Stream<Path> all = Files.list(site)) {
      infos = all.filter(folder -> folder.toString().endsWith(INFO)).sorted().toList();
    }
    for (Path info : infos) {
      String title = info.getFileName().toString();
      String name = WheelCollection.normalized(title.substring(0, title.indexOf('-')));
      if (!others.contains(name)) {
        link(info.resolve("RECORD"), packages);
      }
    }
  }

  private void link(Path record, Path packages) throws IOException {
    for (String line : Files.readAllLines(record, StandardCharsets.UTF_8)) {
      Path file = site.resolve(line.substring(0, line.indexOf(','))).normalize();
      // Its programs are not among the packages.
      if (file.startsWith(site) && Files.isRegularFile(file)) {
        Path place = packages.resolve(site.relativize(file).toString());
        Files.createDirectories(place.getParent());
        UnpackedWheels.linkFile(file, place);
      }
    }
  }
}
