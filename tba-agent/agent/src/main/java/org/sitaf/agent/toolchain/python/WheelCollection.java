package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.agent.sandbox.ToolResult;

/**
 * All wheels that an environment needs. Wheels of the index are fetched with the network, by pip,
 * which executes nothing of them. Where there is only a source archive, it is fetched alone, built
 * without the network, and what the built wheel requires is fetched in the next round.
 *
 * <p>pip never sees with the network what strangers have built or brought, because a wheel may
 * require an address of any kind. It gets an empty wheel of the same name and version instead, and
 * what the wheel requires as lines that have been checked.
 */
final class WheelCollection {
  /** So many packages may have to be built. */
  private static final int MOST_ROUNDS = 10;

  private static final long MOST_BYTES = 4L << 30;

  /** pip's words for a package of which the index has no wheel that fits. */
  private static final Pattern MISSING =
      Pattern.compile(
          "ERROR: No matching distribution found for ([A-Za-z0-9][A-Za-z0-9._-]*)(?:\\[[^\\]]*])?"
              + "[ ]*([A-Za-z0-9._*+!<>=~, -]*)(?:[;(].*)?");

  private final PackageTools tools;
  private final Path environment;
  private final List<String> lines = new ArrayList<>();
  private final List<LocalWheel> local = new ArrayList<>();

  /**
   * Nothing collected yet.
   *
   * @param environment an environment without packages, whose pip fetches
   * @param lines packages of the index
   */
  WheelCollection(PackageTools tools, Path environment, List<String> lines) {
    this.tools = tools;
    this.environment = environment;
    this.lines.addAll(lines);
  }

  /** The user's files are at fault, or the index does not have what they name. */
  static final class PackageException extends Exception {
    private static final long serialVersionUID = 1L;

    PackageException(String message) {
      super(message);
    }
  }

  /** Adds a wheel that the activity brings. */
  void add(Path wheel) throws IOException, InterruptedException, PackageException {
    add(LocalWheel.read(wheel, environment, tools));
  }

  private void add(LocalWheel wheel) {
    local.add(wheel);
    lines.add(wheel.name() + "==" + wheel.version());
    lines.addAll(wheel.requires());
  }

  /**
   * Fetches and builds until everything is there.
   *
   * @param known a folder of wheels that were fetched before
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
        throw new PackageException(tools.complaint(fetched));
      }
      String name = normalized(missing.group(1));
      if (local.stream().anyMatch(wheel -> wheel.name().equals(name))) {
        throw new PackageException(tools.complaint(fetched));
      }
      if (round == MOST_ROUNDS) {
        throw new PackageException(
            "more than " + MOST_ROUNDS + " packages have no wheel and would have to be built");
      }
      Optional<LocalWheel> built =
          new SourceBuild(tools, environment, this::fetchBuildTools)
              .build(name, missing.group(2).strip());
      add(built.orElseThrow(() -> new PackageException(tools.complaint(fetched))));
    }
  }

  private static @org.jspecify.annotations.Nullable Matcher missing(ToolResult fetched) {
    for (String line : fetched.errors().lines().toList()) {
      Matcher missing = MISSING.matcher(line.strip());
      if (missing.matches()) {
        return missing;
      }
    }
    return null;
  }

  /** What a package is built with: wheels of the index alone. */
  private List<Path> fetchBuildTools(List<String> wanted)
      throws IOException, InterruptedException, PackageException {
    Path folder = tools.folder();
    ToolResult fetched = fetchAlone(folder, wanted, List.of());
    if (fetched.code() != 0) {
      throw new PackageException("what it is built with: " + tools.complaint(fetched));
    }
    return wheels(folder);
  }

  private ToolResult fetch(Path folder, List<String> wanted, Path known)
      throws IOException, InterruptedException {
    Path stubs = tools.folder();
    for (LocalWheel wheel : local) {
      wheel.writeStub(stubs);
    }
    return fetchAlone(folder, wanted, List.of(known, stubs));
  }

  private ToolResult fetchAlone(Path folder, List<String> wanted, List<Path> links)
      throws IOException, InterruptedException {
    for (String line : wanted) {
      // The line was checked when it was made; nothing else may reach pip.
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
    for (Path link : links) {
      arguments.addAll(List.of("--find-links", link.toString()));
      readable.add(link);
    }
    return tools.pip(environment, folder, arguments, readable, List.of(), true);
  }

  /** Fetches packages of the index that have wheels, into a folder; says how it ended. */
  ToolResult fetch(Path folder) throws IOException, InterruptedException {
    return fetchAlone(folder, lines, List.of());
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
    if (bytes > MOST_BYTES) {
      throw new PackageException("the packages are larger than " + (MOST_BYTES >> 30) + " GiB");
    }
    return all;
  }

  /** The wheels that a fetch has left. */
  static List<Path> wheels(Path folder) throws IOException {
    return LocalWheel.wheelsIn(folder.resolve("wheels"));
  }

  private static String nameOf(Path wheel) {
    String file = wheel.getFileName().toString();
    return file.substring(0, file.indexOf('-'));
  }

  /** As the index compares names. */
  static String normalized(String name) {
    return name.replaceAll("[-_.]+", "-").toLowerCase(Locale.ROOT);
  }
}
