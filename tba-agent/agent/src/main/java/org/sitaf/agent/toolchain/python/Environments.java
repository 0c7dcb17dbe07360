package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileOwnerAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;

/**
 * Virtual environments, one for each set of packages, kept by their content. Each holds the runtime
 * of test applications, compiled; packages are fetched when an environment is made, and never while
 * a test runs.
 */
final class Environments {
  /** What the runtime needs, and what counts the lines that a component reaches. */
  private static final String BASE = "grpcio==1.85.1\nprotobuf==7.36.2\ncoverage==7.17.3\n";

  /** How many lines of pip's complaint are told. */
  private static final int COMPLAINT = 12;

  private final Interpreter interpreter;
  private final Path runtime;
  private final SharedCache cache;

  Environments(Interpreter interpreter, Path runtime, Path cache) {
    this.interpreter = interpreter;
    this.runtime = runtime;
    this.cache = new SharedCache(cache);
  }

  /** The interpreter of an environment. */
  static Path python(Path environment) {
    return environment.resolve("bin").resolve("python");
  }

  /** Whatever decides what an environment holds beside the component's packages. */
  String identity() throws IOException {
    StringBuilder identity = new StringBuilder();
    identity.append(interpreter).append('\n').append(BASE);
    for (Path file : files(runtime)) {
      identity
          .append(runtime.relativize(file))
          .append(' ')
          .append(digest(Files.readAllBytes(file)));
      identity.append('\n');
    }
    return identity.toString();
  }

  /**
   * The environment of these packages, made when it is asked for first.
   *
   * @throws CompilationException when pip cannot fetch or build what the component needs
   * @throws IOException when not even an environment without them can be made
   */
  synchronized Path with(Requirements requirements, Path scratch, Duration atMost, Sandbox sandbox)
      throws CompilationException, IOException, InterruptedException {
    StringBuilder held = new StringBuilder(identity()).append('\n').append(requirements.text());
    for (Path wheel : requirements.wheels()) {
      held.append(wheel.getFileName()).append(' ').append(digest(Files.readAllBytes(wheel)));
    }
    String key = digest(held.toString().getBytes(StandardCharsets.UTF_8));
    String name = key.substring(0, 24);
    Path environment = cache.entry(name);
    if (Files.isDirectory(environment)) {
      return environment;
    }
    try (SharedCache.Draft draft = cache.draft()) {
      Path fresh = draft.folder();
      // Tests run as other users than the one that it is made by.
      Files.setPosixFilePermissions(fresh, PosixFilePermissions.fromString("rwxr-xr-x"));
      make(fresh, requirements, scratch, atMost, sandbox);
      own(fresh);
      draft.addAs(name);
      return environment;
    }
  }

  private void make(
      Path fresh, Requirements requirements, Path scratch, Duration atMost, Sandbox sandbox)
      throws CompilationException, IOException, InterruptedException {
    Tools tools = new Tools(fresh, scratch, atMost, sandbox, requirements.wheels());
    ToolEnd made =
        tools.run(
            List.of(
                interpreter.executable().toString(),
                "-I",
                "-m",
                "venv",
                "--clear",
                fresh.toString()),
            false);
    if (made.code() != 0) {
      throw new IOException("python -m venv: " + complaint(made));
    }
    // One request for both: what a component pins must fit to what the runtime needs, or be told.
    Path list = scratch.resolve("requirements.txt");
    Files.writeString(list, BASE + requirements.text());
    List<String> pip =
        new ArrayList<>(
            List.of(
                python(fresh).toString(),
                "-I",
                "-m",
                "pip",
                "install",
                "--disable-pip-version-check",
                "--no-input",
                "--quiet",
                "--no-warn-script-location",
                "--requirement",
                list.toString()));
    requirements.wheels().forEach(wheel -> pip.add(wheel.toString()));
    boolean nothingOfItsOwn = requirements.text().isBlank() && requirements.wheels().isEmpty();
    ToolEnd installed = tools.run(pip, true);
    if (installed.code() != 0 && nothingOfItsOwn) {
      throw new IOException(
          "pip cannot fetch what test applications need: " + complaint(installed));
    }
    if (installed.code() != 0) {
      String reason =
          installed.gaveUp()
              ? "pip was given up after " + atMost.toSeconds() + " s"
              : complaint(installed);
      throw new CompilationException(
          "the component's packages cannot be installed",
          List.of(SourceDiagnostic.ofFile(requirements.file(), reason)));
    }
    Path packages = fresh.resolve("lib").resolve("python" + minor()).resolve("site-packages");
    for (Path file : files(runtime)) {
      Path copy = packages.resolve(runtime.relativize(file).toString());
      Files.createDirectories(copy.getParent());
      Files.copy(file, copy);
    }
    ToolEnd compiled =
        tools.run(
            List.of(
                python(fresh).toString(),
                "-I",
                "-m",
                "sitaf_runtime.compiling",
                packages.resolve("sitaf_runtime").toString()),
            false);
    if (compiled.code() != 0) {
      throw new IOException("the runtime of Python tests cannot be compiled: " + compiled.output());
    }
  }

  private String minor() {
    return interpreter.version().substring(0, interpreter.version().lastIndexOf('.'));
  }

  /** The programs that make one environment. */
  private final class Tools {
    private final Path fresh;
    private final Path scratch;
    private final Duration atMost;
    private final Sandbox sandbox;
    private final List<Path> wheels;

    Tools(Path fresh, Path scratch, Duration atMost, Sandbox sandbox, List<Path> wheels) {
      this.wheels = wheels;
      this.fresh = fresh;
      this.scratch = scratch;
      this.atMost = atMost;
      this.sandbox = sandbox;
    }

    ToolEnd run(List<String> command, boolean network) throws IOException, InterruptedException {
      Path temporary = Files.createTempDirectory(scratch, "tool-");
      Confinement confinement =
          Confinement.of(command, scratch, temporary, ProcessLimits.TOOL)
              .withEnvironment(Map.of("PYTHONUTF8", "1"))
              .reading(interpreter.prefixes())
              .reading(List.of(interpreter.executable()))
              .reading(wheels)
              .writing(List.of(fresh));
      return sandbox.run(network ? confinement.withNetwork() : confinement, atMost);
    }
  }

  /** Takes over what the tools have left, so that no later process owns it. */
  private void own(Path fresh) throws IOException {
    UserPrincipal owner = Files.getOwner(cache.directory());
    try (Stream<Path> paths = Files.walk(fresh)) {
      for (Path path : (Iterable<Path>) paths::iterator) {
        if (!Files.getOwner(path, LinkOption.NOFOLLOW_LINKS).equals(owner)) {
          Files.getFileAttributeView(path, FileOwnerAttributeView.class, LinkOption.NOFOLLOW_LINKS)
              .setOwner(owner);
        }
      }
    }
  }

  private static String complaint(ToolEnd end) {
    String text = (end.errors().isBlank() ? end.output() : end.errors()).strip();
    List<String> lines = text.lines().toList();
    List<String> errors = lines.stream().filter(l -> l.startsWith("ERROR")).toList();
    List<String> told = errors.isEmpty() ? lines : errors;
    return String.join("; ", told.subList(Math.max(0, told.size() - COMPLAINT), told.size()));
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> paths = Files.walk(folder)) {
      return new ArrayList<>(
          paths
              .filter(Files::isRegularFile)
              .filter(p -> p.toString().endsWith(".py"))
              .sorted()
              .toList());
    }
  }

  private static String digest(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }
}
