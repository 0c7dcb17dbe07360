package org.sitaf.agent.toolchain.python;

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
 * The processes that make one environment. Those with the network run no code of a package; those
 * that may run some have no network.
 *
 * @param scratch for the folders that they work in
 * @param end when they are given up
 */
record PackageTools(
    Interpreter interpreter, PipSettings settings, Path scratch, Instant end, Sandbox sandbox) {
  private static final int COMPLAINT = 12;
  private static final String SCRIPT = script();

  /** A folder for one of them. */
  Path folder() throws IOException {
    Path folder = Files.createTempDirectory(scratch, "packages-");
    // Each process is another user, who reads what the one before has left.
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
    return folder;
  }

  /** Makes a virtual environment; only Python's own library is in it. */
  ToolResult venv(Path environment) throws IOException, InterruptedException {
    return run(
        List.of(
            interpreter.executable().toString(),
            "-I",
            "-m",
            "venv",
            "--clear",
            environment.toString()),
        folder(),
        List.of(),
        List.of(environment),
        false);
  }

  /** Runs pip of an environment that no package is in yet. */
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

  /** Asks the agent's own script; see there. */
  ToolResult ask(
      Path environment, Path folder, boolean network, List<Path> readable, String... arguments)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of(Environments.python(environment).toString(), "-I", "-c", SCRIPT));
    command.addAll(List.of(arguments));
    List<Path> all = new ArrayList<>(readable);
    all.add(environment);
    return run(command, folder, all, List.of(), network);
  }

  /** Runs a module of the environment on a folder that it may write. */
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

  /** What a tool complains of, in one line. */
  String complaint(ToolResult end) {
    if (end.timedOut()) {
      return "it was given up because making the environment takes too long";
    }
    String text = (end.errors().isBlank() ? end.output() : end.errors()).strip();
    List<String> lines = text.lines().toList();
    List<String> errors = lines.stream().filter(l -> l.startsWith("ERROR")).toList();
    // With a stack, the last line says what it is about.
    boolean stack = text.contains("Traceback (most recent call last)");
    List<String> kept =
        stack ? lines.subList(lines.size() - 1, lines.size()) : errors.isEmpty() ? lines : errors;
    String joined =
        String.join("; ", kept.subList(Math.max(0, kept.size() - COMPLAINT), kept.size()));
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
