package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.lock.ResolvedPackage;

/**
 * Collects all wheels of an environment. pip downloads wheels from the index, which executes no
 * code of them. A package that exists only as source archive is downloaded alone and built without
 * network; the requirements of the built wheel are downloaded in the next round.
 *
 * <p>pip with network access never sees a wheel that was built here or comes with the activity,
 * because the wheel may require any address. It gets an empty wheel of the same name and version
 * instead, and the checked requirements.
 */
final class WheelCollection {
  /** Limit for the number of packages to build. */
  private static final int MAX_ROUNDS = 10;

  private static final long MAX_BYTES = 4L << 30;

  /** pip's message for a package without a suitable wheel in the index. */
  private static final Pattern MISSING =
      Pattern.compile(
          "ERROR: No matching distribution found for ([A-Za-z0-9][A-Za-z0-9._-]*)(?:\\[[^\\]]*])?"
              + "[ ]*([A-Za-z0-9._*+!<>=~, -]*)(?:[;(].*)?");

  private final PackageTools tools;
  private final Path environment;
  private final List<String> lines = new ArrayList<>();
  private final @Nullable ActivityLock lock;
  private final List<LocalWheel> local = new ArrayList<>();

  /**
   * Creates an empty collection.
   *
   * @param environment an environment without packages, whose pip downloads
   * @param lines packages of the index
   * @param lock their exact releases; null if pip chooses them
   */
  WheelCollection(
      PackageTools tools, Path environment, List<String> lines, @Nullable ActivityLock lock) {
    this.tools = tools;
    this.environment = environment;
    this.lines.addAll(lines);
    this.lock = lock;
  }

  /** An error of the user's files, or a package that is not in the index. */
  static final class PackageException extends Exception {
    private static final long serialVersionUID = 1L;

    PackageException(String message) {
      super(message);
    }
  }

  /** Adds a wheel of the activity. */
  void add(Path wheel) throws IOException, InterruptedException, PackageException {
    add(LocalWheel.read(wheel, environment, tools));
  }

  private void add(LocalWheel wheel) {
    local.add(wheel);
    lines.add(wheel.name() + "==" + wheel.version());
    lines.addAll(wheel.requires());
  }

  /**
   * Downloads and builds until the set is complete.
   *
   * @param known folder of wheels that were downloaded before
   */
  List<Path> collect(Path known) throws IOException, InterruptedException, PackageException {
    for (int round = 0; ; round++) {
      Path folder = tools.folder();
      ToolResult fetched = fetch(folder, lines, known);
      if (fetched.code() == 0) {
        return all(folder);
      }
      Matcher missing = missing(fetched);
      if (missing == null) {
        throw new PackageException(tools.errorOf(fetched));
      }
      String name = normalized(missing.group(1));
      if (local.stream().anyMatch(wheel -> wheel.name().equals(name))) {
        throw new PackageException(tools.errorOf(fetched));
      }
      if (round == MAX_ROUNDS) {
        throw new PackageException(
            "more than " + MAX_ROUNDS + " packages have no wheel and would have to be built");
      }
      Optional<LocalWheel> built =
          new SourceBuild(tools, environment, this::fetchBuildTools)
              .build(name, missing.group(2).strip());
      add(built.orElseThrow(() -> new PackageException(tools.errorOf(fetched))));
    }
  }

  private static @Nullable Matcher missing(ToolResult fetched) {
    for (String line : fetched.errors().lines().toList()) {
      Matcher missing = MISSING.matcher(line.strip());
      if (missing.matches()) {
        return missing;
      }
    }
    return null;
  }

  /** Downloads build requirements; only wheels of the index. */
  private List<Path> fetchBuildTools(List<String> wanted)
      throws IOException, InterruptedException, PackageException {
    Path folder = tools.folder();
    ToolResult fetched = fetchAlone(folder, wanted, List.of(), List.of(), List.of());
    if (fetched.code() != 0) {
      throw new PackageException("build requirements: " + tools.errorOf(fetched));
    }
    return wheels(folder);
  }

  private ToolResult fetch(Path folder, List<String> wanted, Path known)
      throws IOException, InterruptedException, PackageException {
    Path stubs = tools.folder();
    List<Path> given = new ArrayList<>(wanted(LocalWheel.wheelsIn(known)));
    for (LocalWheel wheel : local) {
      given.add(wheel.writeStub(stubs));
    }
    return fetchAlone(folder, wanted, constraints(), given, List.of(known));
  }

  /** Those that a line names with their release: pip need not look for them in the index. */
  private List<Path> wanted(List<Path> wheels) {
    return wheels.stream().filter(wheel -> lines.contains(lineOf(wheel))).toList();
  }

  private static String lineOf(Path wheel) {
    return normalized(nameOf(wheel)) + "==" + versionOf(wheel);
  }

  /** The releases that pip may choose, one line each. */
  private List<String> constraints() throws PackageException {
    List<String> constraints = new ArrayList<>();
    for (ResolvedPackage each : lock == null ? List.<ResolvedPackage>of() : lock.packages()) {
      String line = each.name() + "==" + each.version();
      if (each.isMaven()) {
        continue;
      }
      if (!Requirements.isPackage(line)) {
        throw new PackageException(
            ActivityLock.FILE
                + " lists '"
                + line
                + "', which is not a package of the index; write the file by ./sitaf lock");
      }
      constraints.add(line);
    }
    return constraints;
  }

  /**
   * Downloads wheels with what they require.
   *
   * @param given files of packages that are not looked for
   * @param links folders of wheels that need not be downloaded
   */
  private ToolResult fetchAlone(
      Path folder,
      List<String> wanted,
      List<String> constraints,
      List<Path> given,
      List<Path> links)
      throws IOException, InterruptedException {
    List<String> all = new ArrayList<>(wanted);
    all.addAll(constraints);
    for (String line : all) {
      // Lines are checked when they are added; nothing else may reach pip.
      if (!Requirements.isPackage(line)) {
        throw new IllegalArgumentException("'" + line + "' is not a package");
      }
    }
    Path list = tools.folder().resolve("requirements.txt");
    Files.writeString(list, String.join("\n", wanted) + "\n");
    Path into = Files.createDirectories(folder.resolve("wheels"));
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "download",
                "--only-binary=:all:",
                "--no-cache-dir",
                "--dest",
                into.toString(),
                "--requirement",
                list.toString()));
    List<Path> readable = new ArrayList<>(List.of(list));
    if (!constraints.isEmpty()) {
      Path releases = tools.folder().resolve("constraints.txt");
      Files.writeString(releases, String.join("\n", constraints) + "\n");
      arguments.addAll(List.of("--constraint", releases.toString()));
      readable.add(releases);
    }
    for (Path wheel : given) {
      arguments.add(wheel.toString());
      readable.add(wheel);
    }
    for (Path link : links) {
      arguments.addAll(List.of("--find-links", link.toString()));
      readable.add(link);
    }
    return tools.pip(environment, folder, arguments, readable, List.of(), true);
  }

  /** Downloads packages that have wheels into a folder; returns pip's result. */
  ToolResult fetch(Path folder) throws IOException, InterruptedException {
    return fetchAlone(folder, lines, List.of(), List.of(), List.of());
  }

  private List<Path> all(Path folder) throws IOException, PackageException {
    List<Path> all = new ArrayList<>();
    for (Path wheel : wheels(folder)) {
      String name = normalized(nameOf(wheel));
      if (local.stream().noneMatch(own -> own.name().equals(name))) {
        all.add(wheel);
      }
    }
    local.forEach(wheel -> all.add(wheel.file()));
    long bytes = 0;
    for (Path wheel : all) {
      bytes += Files.size(wheel);
    }
    if (bytes > MAX_BYTES) {
      throw new PackageException("the packages are larger than " + (MAX_BYTES >> 30) + " GiB");
    }
    return all;
  }

  /** The wheels that a download has created. */
  static List<Path> wheels(Path folder) throws IOException {
    return LocalWheel.wheelsIn(folder.resolve("wheels"));
  }

  /**
   * The name, release and digest of each wheel of a complete collection. One that was built here
   * counts as its source archive, since a build never gives the same bytes again.
   */
  List<ResolvedPackage> resolved(List<Path> collected) throws IOException {
    List<ResolvedPackage> resolved = new ArrayList<>();
    for (Path wheel : collected) {
      LocalWheel own =
          local.stream().filter(each -> each.file().equals(wheel)).findFirst().orElse(null);
      resolved.add(
          own == null
              ? new ResolvedPackage(
                  normalized(nameOf(wheel)), versionOf(wheel), EnvironmentPackages.digest(wheel))
              : new ResolvedPackage(
                  own.name(), own.version(), EnvironmentPackages.digest(own.origin())));
    }
    return resolved;
  }

  private static String nameOf(Path wheel) {
    String file = wheel.getFileName().toString();
    return file.substring(0, file.indexOf('-'));
  }

  private static String versionOf(Path wheel) {
    return wheel.getFileName().toString().split("-", 3)[1];
  }

  /** Normalizes a name like the index. */
  static String normalized(String name) {
    return name.replaceAll("[-_.]+", "-").toLowerCase(Locale.ROOT);
  }
}
