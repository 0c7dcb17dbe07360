package org.sitaf.agent.toolchain.python;

import java.io.File;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The ROS 2 of this machine: what the environment of the agent names, as {@code setup.bash} of ROS
 * sets it, otherwise what {@code /opt/ros} holds.
 *
 * @param version the name of the distribution, such as {@code jazzy}, or the release of rclpy
 * @param prefixes folders of the installation and its overlays, in the order of their precedence
 * @param modules folders of Python modules
 * @param libraries folders of shared libraries
 */
public record RosInstallation(
    String version, List<Path> prefixes, List<Path> modules, List<Path> libraries) {
  private static final Path SYSTEM = Path.of("/opt/ros");

  /** Python packages of the distribution, which packages of ROS depend on, such as PyYAML. */
  private static final Path SYSTEM_MODULES = Path.of("/usr/lib/python3/dist-packages");

  private static final String PREFIXES = "AMENT_PREFIX_PATH";
  private static final String LIBRARIES = "LD_LIBRARY_PATH";
  private static final String DISTRIBUTION = "ROS_DISTRO";
  private static final String PREFERRED = "jazzy";
  private static final Pattern VERSION =
      Pattern.compile("<version>\\s*([0-9.]{1,30})\\s*</version>");

  public RosInstallation {
    Objects.requireNonNull(version);
    prefixes = List.copyOf(prefixes);
    modules = List.copyOf(modules);
    libraries = List.copyOf(libraries);
  }

  /**
   * The result of a search.
   *
   * @param problem why there is none that can be used; empty if it was found
   */
  public record Lookup(Optional<RosInstallation> found, String problem) {}

  /**
   * Searches for ROS 2 with rclpy.
   *
   * @param python version of the interpreter that test applications use, such as 3.12.3
   */
  static Lookup find(String python) throws IOException {
    return find(python, System.getenv(), SYSTEM, SYSTEM_MODULES);
  }

  static Lookup find(
      String python, Map<String, String> environment, Path system, Path systemModules)
      throws IOException {
    List<Path> prefixes = folders(environment.get(PREFIXES));
    boolean isSourced = !prefixes.isEmpty();
    if (!isSourced) {
      prefixes = ofSystem(system).map(List::of).orElse(List.of());
    }
    if (prefixes.isEmpty()) {
      return new Lookup(
          Optional.empty(),
          "no ROS 2 is installed in " + system + ", and " + PREFIXES + " is not set");
    }
    String release = Stream.of(python.split("\\.")).limit(2).collect(Collectors.joining("."));
    Set<Path> modules = new LinkedHashSet<>();
    Set<Path> libraries = new LinkedHashSet<>();
    if (isSourced) {
      modules.addAll(folders(environment.get("PYTHONPATH")));
      libraries.addAll(folders(environment.get(LIBRARIES)));
    }
    for (Path prefix : prefixes) {
      for (String folder : List.of("lib", "local/lib")) {
        for (String packages : List.of("site-packages", "dist-packages")) {
          Path found = prefix.resolve(folder).resolve("python" + release).resolve(packages);
          if (Files.isDirectory(found)) {
            modules.add(found);
            // Libraries that wheels bring along.
            libraries.addAll(list(found, "ros_*.libs"));
          }
        }
      }
      libraries.addAll(list(prefix, "lib"));
      for (Path vendored : list(prefix.resolve("opt"), "*")) {
        libraries.addAll(list(vendored, "lib"));
      }
    }
    if (modules.stream().noneMatch(folder -> Files.isDirectory(folder.resolve("rclpy")))) {
      return new Lookup(
          Optional.empty(),
          "the ROS 2 in "
              + prefixes.stream().map(Path::toString).collect(Collectors.joining(", "))
              + " has no rclpy for Python "
              + release
              + ", which test applications use; install the Python that it is made for, and let"
              + " python3 be that one");
    }
    if (Files.isDirectory(systemModules)) {
      modules.add(systemModules);
    }
    return new Lookup(
        Optional.of(
            new RosInstallation(
                version(environment, prefixes),
                prefixes,
                List.copyOf(modules),
                List.copyOf(libraries))),
        "");
  }

  private static Optional<Path> ofSystem(Path system) throws IOException {
    List<Path> distributions = new ArrayList<>(list(system, "*"));
    distributions.removeIf(folder -> !Files.isDirectory(folder.resolve("share/rclpy")));
    return distributions.stream()
        .filter(folder -> folder.endsWith(PREFERRED))
        .findFirst()
        .or(() -> distributions.stream().reduce((a, b) -> b));
  }

  private static String version(Map<String, String> environment, List<Path> prefixes)
      throws IOException {
    String named = environment.get(DISTRIBUTION);
    if (named != null && !named.isBlank()) {
      return named.strip();
    }
    for (Path prefix : prefixes) {
      Path description = prefix.resolve("share/rclpy/package.xml");
      if (Files.isRegularFile(description)) {
        if (prefix.startsWith(SYSTEM)) {
          return String.valueOf(prefix.getFileName());
        }
        Matcher version = VERSION.matcher(Files.readString(description));
        return "rclpy " + (version.find() ? version.group(1) : "of an unknown version");
      }
    }
    return "of an unknown version";
  }

  private static List<Path> folders(@Nullable String path) {
    return path == null
        ? List.of()
        : Stream.of(path.split(File.pathSeparator))
            .filter(folder -> folder.startsWith("/"))
            .map(folder -> Path.of(folder).normalize())
            .filter(Files::isDirectory)
            .distinct()
            .toList();
  }

  private static List<Path> list(Path folder, String glob) throws IOException {
    List<Path> found = new ArrayList<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder, glob)) {
        entries.forEach(
            entry -> {
              if (Files.isDirectory(entry)) {
                found.add(entry);
              }
            });
      }
    }
    found.sort(null);
    return found;
  }

  /** Variables of the process of a node. */
  Map<String, String> environment() {
    Map<String, String> environment = new LinkedHashMap<>();
    environment.put(PREFIXES, joined(prefixes));
    environment.put(LIBRARIES, joined(libraries));
    environment.put(DISTRIBUTION, version);
    environment.put("SITAF_ROS_MODULES", joined(modules));
    return environment;
  }

  private static String joined(List<Path> folders) {
    return folders.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
  }

  /** What nodes are compiled with: the installation and the release of its libraries. */
  String identity() {
    StringBuilder identity = new StringBuilder("\n");
    for (Path prefix : prefixes) {
      identity.append(prefix).append(' ');
      for (String part : List.of("share/rclcpp/package.xml", "share/rcl/package.xml")) {
        identity.append(prefix.resolve(part).toFile().lastModified()).append(' ');
      }
    }
    return identity.append(version).toString();
  }

  /** The folders that the process reads. */
  List<Path> readable() {
    return Stream.of(prefixes, modules, libraries).flatMap(List::stream).distinct().toList();
  }
}
