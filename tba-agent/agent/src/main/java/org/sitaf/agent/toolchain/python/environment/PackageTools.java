package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;

/**
 * The processes that create one environment. Those with network access execute no code of a
 * package; those that may execute some have no network.
 *
 * @param scratch for their working folders
 * @param limit time limit of all of them together
 * @param end deadline after which they are killed
 */
record PackageTools(
    Interpreter interpreter,
    PipSettings settings,
    Path scratch,
    Duration limit,
    Instant end,
    Sandbox sandbox) {
  private static final int MAX_ERROR_LINES = 12;

  /** Added to the number of a signal, as shells do. */
  private static final int SIGNAL_BASE = 128;

  private static final String SCRIPT = script();

  /** Creates a working folder. */
  Path folder() throws IOException {
    Path folder = Files.createTempDirectory(scratch, "packages-");
    // Each process runs as another user and reads files of the previous one.
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
    return folder;
  }

  /** Creates a virtual environment with Python's own library and pip. */
  ToolResult venv(Path environment) throws IOException, InterruptedException {
    return venv(environment, List.of());
  }

  /** Creates a virtual environment with Python's own library only. */
  ToolResult emptyVenv(Path environment) throws IOException, InterruptedException {
    return venv(environment, List.of("--without-pip"));
  }

  private ToolResult venv(Path environment, List<String> options)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.addAll(List.of(interpreter.executable().toString(), "-I", "-m", "venv", "--clear"));
    command.addAll(options);
    command.add(environment.toString());
    return run(command, folder(), List.of(), List.of(environment), false);
  }

  /** Runs pip of an environment without packages. */
  ToolResult pip(
      Path environment,
      Path folder,
      List<String> arguments,
      List<Path> readable,
      List<Path> writable,
      boolean network)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of(Environments.python(environment).toString(), "-I", "-m", "pip"));
    command.addAll(arguments);
    command.addAll(List.of("--disable-pip-version-check", "--no-input", "--quiet"));
    List<Path> all = new ArrayList<>(readable);
    if (!writable.contains(environment)) {
      all.add(environment);
    }
    return run(command, folder, all, writable, network);
  }

  /** Runs the agent's script {@code packages.py}. */
  ToolResult runScript(
      Path environment, Path folder, boolean network, List<Path> readable, String... arguments)
      throws IOException, InterruptedException {
    List<Path> all = new ArrayList<>(readable);
    all.add(environment);
    return run(script(environment, List.of(arguments)), folder, all, List.of(), network);
  }

  /**
   * Installs each wheel alone, without network, into a folder of its own.
   *
   * @param trees empty folders by wheel
   */
  ToolResult unpack(Path environment, Map<Path, Path> trees)
      throws IOException, InterruptedException {
    List<String> arguments = new ArrayList<>(List.of("unpack"));
    trees.forEach((wheel, tree) -> arguments.addAll(List.of(wheel.toString(), tree.toString())));
    List<Path> readable = new ArrayList<>(trees.keySet());
    readable.add(environment);
    return run(
        script(environment, arguments), folder(), readable, List.copyOf(trees.values()), false);
  }

  private static List<String> script(Path environment, List<String> arguments) {
    List<String> command =
        new ArrayList<>(List.of(Environments.python(environment).toString(), "-I", "-c", SCRIPT));
    command.addAll(arguments);
    return command;
  }

  /** Runs a module of the environment on a writable folder. */
  ToolResult module(Path environment, String module, Path folder, Path written)
      throws IOException, InterruptedException {
    return run(
        List.of(Environments.python(environment).toString(), "-I", "-m", module, folder.toString()),
        folder(),
        List.of(),
        List.of(written),
        false);
  }

  private ToolResult run(
      List<String> command, Path folder, List<Path> readable, List<Path> writable, boolean network)
      throws IOException, InterruptedException {
    Confinement confinement =
        Confinement.of(command, folder, folder, ProcessLimits.TOOL)
            .withEnvironment(Map.of("PYTHONUTF8", "1", "PIP_CONFIG_FILE", "/dev/null"))
            .reading(interpreter.prefixes())
            .reading(List.of(interpreter.executable()))
            .reading(readable)
            .writing(writable);
    if (network) {
      Map<String, String> environment = new TreeMap<>(settings.environment());
      environment.put("PIP_CONFIG_FILE", "/etc/pip.conf");
      Path configuration = settings.configuration();
      if (configuration != null) {
        Path copy = folder.resolve("pip.conf");
        Files.copy(configuration, copy);
        environment.put("PIP_CONFIG_FILE", copy.toString());
      }
      confinement =
          confinement.withEnvironment(environment).reading(settings.readable()).withNetwork();
    }
    Duration left = Duration.between(Instant.now(), end);
    return sandbox.run(confinement, left.toMillis() < 1 ? Duration.ofMillis(1) : left);
  }

  /** A tool's error message in one line. */
  String errorOf(ToolResult end) {
    if (end.timedOut()) {
      return "preparing the environment took longer than "
          + limit.toSeconds()
          + " s; raise limits: prepare_s in activity.yaml";
    }
    String text = (end.errors().isBlank() ? end.output() : end.errors()).strip();
    if (text.isEmpty()) {
      return end.code() > SIGNAL_BASE
          ? "it was killed by signal " + (end.code() - SIGNAL_BASE) + ", perhaps for lack of memory"
          : "it ended with exit code " + end.code() + " and no message";
    }
    List<String> lines = text.lines().toList();
    List<String> errors = lines.stream().filter(l -> l.startsWith("ERROR")).toList();
    // The last line of a stack trace is the message.
    boolean stack = text.contains("Traceback (most recent call last)");
    List<String> kept =
        stack ? lines.subList(lines.size() - 1, lines.size()) : errors.isEmpty() ? lines : errors;
    String joined =
        String.join("; ", kept.subList(Math.max(0, kept.size() - MAX_ERROR_LINES), kept.size()));
    return joined.substring(0, Math.min(2000, joined.length()));
  }

  private static String script() {
    try (InputStream stream =
        Objects.requireNonNull(PackageTools.class.getResourceAsStream("packages.py"))) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
