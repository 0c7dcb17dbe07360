package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.python.environment.WheelCollection.PackageException;

/**
 * Builds the wheel of a package that the index has only as source. The build runs without network
 * and can write only to the output folder.
 *
 * @param environment without packages; its Python downloads and reads files
 * @param buildTools downloads the wheels of the build requirements
 */
record SourceBuild(PackageTools tools, Path environment, Fetch buildTools) {
  private static final Pattern ARCHIVE =
      Pattern.compile("[A-Za-z0-9_.+!-]{1,200}\\.(tar\\.gz|zip|tgz|tar\\.bz2|tar\\.xz)");
  private static final List<String> ALWAYS = List.of("setuptools", "wheel");
  private static final int MAX_TOOLS = 50;

  /** Downloads wheels of these packages. */
  interface Fetch {
    List<Path> wheels(List<String> lines)
        throws IOException, InterruptedException, PackageException;
  }

  /** The wheel; empty if the index has no sources either. */
  Optional<LocalWheel> build(String name, String specifier)
      throws IOException, InterruptedException, PackageException {
    Path fetch = tools.folder();
    ToolResult fetched =
        tools.runScript(environment, fetch, true, List.of(), "source", name, specifier);
    if (fetched.code() != 0) {
      if (fetched.errors().contains("the index has no source archive")) {
        return Optional.empty();
      }
      throw new PackageException(name + ": " + tools.errorOf(fetched));
    }
    Path archive = fetch.resolve(value(fetched, "file"));
    String version = value(fetched, "version");
    if (!ARCHIVE.matcher(archive.getFileName().toString()).matches()
        || !archive.getParent().equals(fetch)
        || !Files.isRegularFile(archive, LinkOption.NOFOLLOW_LINKS)) {
      throw new PackageException(name + ": its source archive cannot be used");
    }
    Path build = environment(name, archive);
    Path folder = tools.folder();
    Path into = Files.createDirectories(folder.resolve("wheels"));
    ToolResult built =
        tools.pip(
            build,
            folder,
            List.of(
                "wheel",
                "--no-index",
                "--no-deps",
                "--no-build-isolation",
                "--no-cache-dir",
                "--wheel-dir",
                into.toString(),
                archive.toString()),
            List.of(archive),
            List.of(),
            false);
    if (built.code() != 0) {
      throw new PackageException(
          name + " has no wheel and cannot be built: " + tools.errorOf(built));
    }
    List<Path> wheels = LocalWheel.wheelsIn(into);
    if (wheels.size() != 1) {
      throw new PackageException(
          name + ": its build created " + wheels.size() + " wheels instead of 1");
    }
    LocalWheel wheel = LocalWheel.read(wheels.get(0), environment, tools);
    if (!wheel.name().equals(name) || !wheel.version().equals(version)) {
      throw new PackageException(
          name
              + " "
              + version
              + ": its build created the wheel of "
              + wheel.name()
              + " "
              + wheel.version());
    }
    return Optional.of(wheel.builtFrom(archive));
  }

  /** Creates an environment with the build requirements. */
  private Path environment(String name, Path archive)
      throws IOException, InterruptedException, PackageException {
    ToolResult answer =
        tools.runScript(
            environment, tools.folder(), false, List.of(archive), "build", archive.toString());
    if (answer.code() != 0) {
      throw new PackageException(name + ": " + tools.errorOf(answer));
    }
    List<String> wanted = new ArrayList<>(ALWAYS);
    for (String line : answer.output().lines().limit(MAX_TOOLS).toList()) {
      LocalWheel.requirement(line.substring(line.indexOf('\t') + 1), name).forEach(wanted::add);
    }
    List<Path> wheels = buildTools.wheels(wanted);
    Path build = Files.createDirectories(tools.folder().resolve("environment"));
    ToolResult made = tools.venv(build);
    if (made.code() != 0) {
      throw new IOException("python -m venv: " + tools.errorOf(made));
    }
    ToolResult installed = install(build, wheels);
    if (installed.code() != 0) {
      throw new PackageException(name + ": " + tools.errorOf(installed));
    }
    return build;
  }

  /** Installs only these wheels, without network. */
  private ToolResult install(Path build, List<Path> wheels)
      throws IOException, InterruptedException {
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "install",
                "--no-index",
                "--no-deps",
                "--no-cache-dir",
                "--no-compile",
                "--no-warn-script-location"));
    wheels.forEach(wheel -> arguments.add(wheel.toString()));
    return tools.pip(build, tools.folder(), arguments, wheels, List.of(build), false);
  }

  private static String value(ToolResult answer, String word) throws PackageException {
    return answer
        .output()
        .lines()
        .filter(line -> line.startsWith(word + "\t"))
        .map(line -> line.substring(word.length() + 1))
        .findFirst()
        .orElseThrow(() -> new PackageException("the index gave no answer"));
  }
}
